// The extremes of the columns of a motion, for texts and for sweeps alike.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// Values parallel to the columns of a motion.
using MotionValues = std::vector<std::optional<double>>;

/// Where a column is least and greatest; null where it has no value at all.
struct MotionExtremes {
  const MotionValues* least = nullptr;
  const MotionValues* greatest = nullptr;
};

/// Those of the rows, and the positions at the dead points between them: what lies between the
/// steps is known of positions where a freedom turns back, and of nothing else.
std::vector<const MotionValues*> all_values(const MotionTable& motion);

MotionExtremes find_extremes(const std::vector<const MotionValues*>& values, std::size_t column);

}  // namespace kinestat
