// A point of a duty cycle: a case with its magnitudes, which holds for some time.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/mechanism.hpp"

namespace kinestat {

/// A case with its known magnitudes [SI], in the order of the case, and its duration.
struct DutyPoint {
  std::size_t which = 0;  ///< index into Mechanism::cases
  std::vector<double> motions;
  std::vector<double> actions;
  double duration = 0.0;   ///< [s]
  SourceRange where = {};  ///< empty for a line of a table
  int line = 0;            ///< line of a table, from 1; 0 for a point of the file
};

/// Whether a magnitude is a speed or a load of an input.
enum class DutySide { motion, action };

/// A point with the magnitudes that the case itself has.
DutyPoint point_of(const Mechanism& mechanism, std::size_t which);

/// The index of the motion or action of an actuator among the known magnitudes of a case; empty if
/// the case does not give this magnitude.
std::optional<std::size_t> find_known(const Mechanism& mechanism,
                                      std::size_t which,
                                      std::size_t actuator,
                                      DutySide side);

}  // namespace kinestat
