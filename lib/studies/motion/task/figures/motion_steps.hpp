// Steps of a motion, whole or not, and shares of the ranges of its drives.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// The share of the ranges at which a motion is after so many steps, whole or not: in time where it
/// is a motion in time.
double share_at_step(const FoundMotion& motion, double step);

/// The inverse.
double step_at_share(const FoundMotion& motion, double share);

/// At which step a row is: a motion in time that ends early has its last row between two of them.
double step_of_row(const FoundMotion& motion, std::size_t row);

/// In a motion in time the time of a row that is a step, as share of the whole; empty of a place
/// between two steps.
std::optional<double> time_of_row(const FoundMotion& motion, std::size_t row);

/// What falls on a row but for rounding is at the row.
double nearest_row(double step);

/// Where between rows, which stand at those steps, a step is.
double row_at(std::span<const double> steps, double step);

}  // namespace kinestat
