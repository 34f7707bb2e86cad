// What the values of a motion come to at a place that they are looked at beside.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/figures/motion_figures.hpp"

namespace kinestat {

/// Of values that run straight towards the place, by the parabola through the three; what that
/// adds to the line bounds the error, and so does how well the place is known.
void go_to_limits(FigurePlace& place);

/// Without what grows towards it: what runs straight there comes nearer by as much each time.
std::vector<std::optional<double>> limits_at(const FigurePlace& place);

/// What lines through the rows, which stand at those steps, pass between them.
std::vector<MotionPlace> places_of_lines(std::span<const FigurePlace> places,
                                         std::span<const double> steps);

}  // namespace kinestat
