// Figures of motions: one number for a whole column of a motion, which a sweep reports.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "description/mechanism_description.hpp"

namespace kinestat {

enum class MotionFigure {
  least,
  greatest,
  range,              ///< the greatest minus the least value: a stroke
  mean,               ///< over time, or over the way of the drives
  rms,                ///< root of the mean square over time
  peak,               ///< the largest absolute value
  dead_points,        ///< how often a freedom reverses
  overall_efficiency  ///< of the case, by its mean powers
};

/// The name of a figure, such as "s.vx.position.range": a column of the motion, with dots between
/// its parts, and the figure.
struct MotionFigureName {
  std::string column;  ///< empty for the dead points of all freedoms and what is of the whole
  MotionFigure figure = MotionFigure::range;
};

std::string_view word_of(MotionFigure figure);

/// The words of all figures, in the order of their enumerators.
std::span<const std::string> motion_figure_words();

/// Splits a name; empty if it does not end in a figure. Whether the motion has the column is
/// checked later.
std::optional<MotionFigureName> motion_figure_of(std::string_view name);

/// Whether the sweep reports figures of the motion only, and nothing of a single position.
bool sweeps_motion_alone(const MechanismDescription& description);

}  // namespace kinestat
