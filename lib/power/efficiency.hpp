// What losses leave of the power from the inputs of a case to its outputs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mechanism/case.hpp"

namespace kinestat {

/// Power of the outputs over that of the inputs. Empty where the case does not name both, where the
/// inputs give no power or the outputs too give some (self-locking), and where loads or other
/// actuators exchange power: the reason says so, but for a case that does not name both.
struct Efficiency {
  std::optional<double> value;
  std::string reason;
  bool is_self_locking = false;  ///< losses take more than the inputs give: outputs drive too
};

/// From the powers of the actuators and loads of the case [W].
Efficiency find_efficiency(const Case& which,
                           const std::vector<double>& actuators,
                           const std::vector<double>& loads);

}  // namespace kinestat
