// A mechanism file that was read and bound.
#pragma once

#include <optional>

#include "mechanism/mechanism.hpp"
#include "report/analysis.hpp"

namespace kinestat {

struct Loaded {
  MechanismDescription description;
  Mechanism mechanism;
  std::optional<ShiftAnalysis> shift;  ///< whose gears are among the cases
};

}  // namespace kinestat
