// Curves of a sweep, or its points: its quantities over one of the varied parameters.
#pragma once

#include <string>

#include "draw/chart.hpp"
#include "studies/sweep/report/sweep_table.hpp"

namespace kinestat {

/// Why there are no curves, and what to do: "its 'require:' allows none of its 40 states"; empty if
/// there are some.
std::string why_no_curves_of_sweep(const SweepTable& sweep);

/// One chart a quantity, over the parameter with the most values; a line for every case and every
/// choice of the other parameters, as far as lines can be told apart, or the points of a sample for
/// every case. No charts if no parameter has two values.
Figure sweep_figure(const SweepTable& sweep, const std::string& title);

}  // namespace kinestat
