// Time against error of the methods of solution.
#pragma once

#include <string>
#include <vector>

#include "draw/chart.hpp"
#include "studies/benchmark/report/benchmark_report.hpp"

namespace kinestat {

/// One chart a side and case that were measured: both axes logarithmic, a marker a method, a line
/// through those that no other method beats in both. Methods without an answer to some extreme are
/// left out; an error of zero stands a decade below all others. Empty charts if nothing was
/// measured.
Figure pareto_figure(const std::string& title, const std::vector<BenchmarkedCase>& cases);

}  // namespace kinestat
