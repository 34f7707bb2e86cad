// The section `duty` bound to numbers: cases with magnitudes, each for a while.
#pragma once

#include <optional>
#include <vector>

#include "core/diagnostic.hpp"
#include "mechanism/mechanism.hpp"

namespace kinestat {

/// One case for a while, with its known magnitudes there [SI], in the order of the case's.
struct DutyPoint {
  std::size_t which = 0;  ///< index into Mechanism::cases
  std::vector<double> motions;
  std::vector<double> actions;
  double duration = 0.0;   ///< [s]
  SourceRange where = {};  ///< empty for a line of a table
  int line = 0;            ///< of a table, from 1; 0 for a point of the file
};

struct DutyPlan {
  std::vector<DutyPoint> points;
  double repetitions = 1.0;
  std::optional<double> gear_exponent;
  std::optional<double> bearing_exponent;
};

/// What the section says beside its points. Empty iff an error was added.
std::optional<DutyPlan> bind_duty(const MechanismDescription& description,
                                  const Mechanism& mechanism,
                                  Diagnostics& found);

}  // namespace kinestat
