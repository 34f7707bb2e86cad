// The efficiency of a case, from its inputs to its outputs.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mechanism/cases/case.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// The efficiency is the power of all outputs over the power of all inputs, which are actuators and
/// loads. It has no value, and `reason` says why,
/// - if an input takes power, or no input gives any;
/// - if an output gives power (the case is self-locking if all outputs together do);
/// - if other actuators or loads exchange power; the power of a slipping clutch or brake is a loss.
/// It has no value, and no reason, if the case does not name inputs and outputs. It is never below
/// 0; if it is 0, there is a reason too.
struct Efficiency {
  std::optional<double> value;
  std::string reason;
  bool is_self_locking = false;      ///< losses exceed the power of the inputs: outputs drive too
  std::optional<double> other = {};  ///< of a second answer of large losses; `reason` mentions it
};

/// The powers of a case [W].
struct CasePowers {
  const std::vector<double>& actuators;
  const std::vector<double>& loads;
  double largest = 0.0;  ///< the largest power in the whole network
};

/// A clutch or brake, which loses the power that it takes.
bool is_shift_element(const Topology& topology, std::size_t actuator);

Efficiency find_efficiency(const Topology& topology, const Case& which, const CasePowers& powers);

}  // namespace kinestat
