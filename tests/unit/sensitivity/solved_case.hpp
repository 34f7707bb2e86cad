// A mechanism whose first case is solved and ready to be differentiated by all parameters.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/sensitivity/adjoint.hpp"

namespace kinestat {

/// From the text of a mechanism file, which has no complaints.
struct Solved {
  MechanismDescription description;
  Mechanism mechanism;
  MechanismDerivatives derivatives;
  KinematicSolution motion;
  StaticSolution action;

  explicit Solved(const std::string& text);

  DualCase values() const;

  /// Of a value, which must be there, towards each parameter in SI.
  std::vector<std::optional<double>> derivatives_of(const std::string& name) const;
};

}  // namespace kinestat
