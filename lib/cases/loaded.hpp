// A mechanism file that was read and bound.
#pragma once

#include <optional>

#include "cases/analysis.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

struct Loaded {
  MechanismDescription description;
  Mechanism mechanism;
  std::optional<ShiftAnalysis> shift;  ///< whose gears are among the cases
};

}  // namespace kinestat
