// Where speeds of a motion change too much within one step for their peaks to be seen.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace kinestat {

/// Of the freedoms at a position; empty where there are none.
using FreedomRates = std::vector<std::optional<double>>;

/// Whether some freedom changes its speed between two rows by more than half of its greatest.
bool has_sharp_bends(std::span<const FreedomRates> rows);

/// Halves these steps, and their halves, until no speed does so between two places, as beside a
/// change point that the mechanism passes closely. `look` answers the speeds at a step.
void look_into_sharp_bends(std::span<const FreedomRates> rows,
                           const std::function<FreedomRates(double step)>& look);

}  // namespace kinestat
