// What accuracy costs, in the forms of a report.
#pragma once

#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "report/report_forms.hpp"
#include "studies/benchmark/trade_off.hpp"

namespace kinestat {

struct BenchmarkedCase {
  std::string label;
  TradeOff motion;
  TradeOff action;
};

/// JSON `bench.<case>.<side>.methods.<method>`: times in units of a dense LU in double, errors of
/// each extreme, the Pareto front; tables with one line a method. Times differ from run to run.
FileReport make_benchmark_report(const std::string& file,
                                 const MechanismDescription& description,
                                 const std::vector<BenchmarkedCase>& cases,
                                 const ReportForms& forms,
                                 const Diagnostics& found);

}  // namespace kinestat
