// What a sweep reports of a whole motion: a figure of one of its columns.
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
  range,       ///< the greatest less the least: a stroke
  mean,        ///< over the way of the drives, or in time
  rms,         ///< root of the mean square in time
  peak,        ///< the largest size, whatever the sign
  dead_points  ///< how often a freedom turns back
};

/// "s.vx.position.range": the column of the motion with dots between its parts, and what of it.
struct MotionFigureName {
  std::string column;  ///< empty of the dead points of all freedoms
  MotionFigure figure = MotionFigure::range;
};

std::string_view word_of(MotionFigure figure);

/// In the order of their enumerators.
std::span<const std::string> motion_figure_words();

/// Empty where a name does not end in a figure. Whether the motion has the column shows later.
std::optional<MotionFigureName> motion_figure_of(std::string_view name);

/// Whether all that the sweep reports is of the motion, and nothing of a single position.
bool sweeps_motion_alone(const MechanismDescription& description);

}  // namespace kinestat
