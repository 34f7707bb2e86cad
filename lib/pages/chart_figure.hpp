// A chart on the page, with its values for the script that tells them.
#pragma once

#include <string>

#include "draw/chart.hpp"
#include "pages/html.hpp"

namespace kinestat {

/// What a chart on the page belongs to.
struct ChartPlace {
  std::string id;       ///< of the figure; that of its values begins with it
  int number = 0;       ///< of the figure
  std::string caption;  ///< without the number
  std::string follows;  ///< id of the section whose motion its points are the rows of; or empty
};

/// Adds the figure, of which `chart` is the first and only chart. Its values have six significant
/// digits, as tables have.
void add_chart_figure(const Figure& figure, const ChartPlace& place, Html& html);

}  // namespace kinestat
