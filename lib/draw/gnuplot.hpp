// Charts as text for gnuplot, with their data inside.
#pragma once

#include <string>
#include <string_view>

#include "draw/bar_map.hpp"
#include "draw/chart.hpp"

namespace kinestat {

/// How every such text begins.
std::string_view gnuplot_signature();

/// A script that draws the charts below each other in whatever terminal the user has set.
std::string gnuplot_text(const Figure& figure);

/// A script with one histogram a block.
std::string gnuplot_text(const BarMap& map);

}  // namespace kinestat
