// What a motion comes to in a few figures: extremes and means of its columns.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// The value of a column of the table at a share of the ranges of the drives, behind that row and
/// no later than the next one; empty where there is none.
using BetweenSteps =
    std::function<std::optional<double>(std::size_t column, std::size_t row, double share)>;

/// Fills the figures of a table whose rows stand at those shares of the ranges and whose events are
/// known. Extremes are looked for between the steps, by parabolas through the three positions
/// around each; without `between` they are those of the steps and of positions at dead points.
void add_figures(std::span<const double> shares, const BetweenSteps& between, MotionTable& table);

}  // namespace kinestat
