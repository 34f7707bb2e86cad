// Efficiency maps as small panels, a case each.
#pragma once

#include <span>
#include <vector>

#include "cases/analysis.hpp"
#include "draw/picture.hpp"
#include "studies/duty/efficiency_map.hpp"

namespace kinestat {

/// Where one shade ends and the next begins, ascending, of efficiencies from `low` to `high`: round
/// efficiencies whose losses have the ratios 1, 2, 5, 10, the best seven of them; where fewer than
/// four lie between, some at equal distances.
std::vector<double> efficiency_levels(double low, double high);

/// Cells as shades, the darker the better on a light page, empty ones hatched; over them the points
/// of the duty, larger for longer. An efficiency that is the same everywhere is a number. All
/// panels have the same shades. There must be a map; `analysis` has its mechanism.
Picture draw_efficiency_maps(const Analysis& analysis, std::span<const EfficiencyMap> maps);

}  // namespace kinestat
