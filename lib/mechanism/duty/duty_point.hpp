// A point of a duty: a case with magnitudes, for a while.
#pragma once

#include <optional>
#include <vector>

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

/// Whether a magnitude is a speed or a load of an input.
enum class DutySide { motion, action };

/// The point of a case with the magnitudes that the case has.
DutyPoint point_of(const Mechanism& mechanism, std::size_t which);

/// Index into the motions or actions of the case of a point; empty if the case does not know that
/// magnitude of the actuator.
std::optional<std::size_t> find_known(const Mechanism& mechanism,
                                      std::size_t which,
                                      std::size_t actuator,
                                      DutySide side);

}  // namespace kinestat
