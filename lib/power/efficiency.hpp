// What losses leave of the power from the inputs of a case to its outputs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mechanism/cases/case.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Power of the outputs over that of the inputs, actuators and loads, each summed. Empty where the
/// case does not name both, where an input takes power or none gives any, where an output gives
/// some (self-locking if all of them together do), and where other loads or actuators exchange
/// power, but for what a clutch or brake takes, which slips: that is lost. The reason says so, but
/// for a case that does not name both. Never below 0; where it is 0 there is a reason too.
struct Efficiency {
  std::optional<double> value;
  std::string reason;
  bool is_self_locking = false;  ///< losses take more than the inputs give: the outputs drive too
  std::optional<double> other = {};  ///< of another answer of large losses; the reason names it
};

/// The powers of a case [W].
struct CasePowers {
  const std::vector<double>& actuators;
  const std::vector<double>& loads;
  double largest = 0.0;                      ///< of the whole network
  const std::vector<bool>* slips = nullptr;  ///< of each actuator, whether what it takes is lost: a
                                             ///< clutch or brake; null: none
};

/// The clutches and brakes among the actuators.
std::vector<bool> find_slipping(const Topology& topology);

Efficiency find_efficiency(const Case& which, const CasePowers& powers);

}  // namespace kinestat
