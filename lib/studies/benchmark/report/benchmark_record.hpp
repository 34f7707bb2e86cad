// What a report of accuracy against cost says, whole.
#pragma once

#include "record/record.hpp"
#include "studies/benchmark/report/benchmark_report.hpp"

namespace kinestat {

struct BenchmarkReportView {
  const std::string& file;  ///< path as the user gave it
  const MechanismDescription& description;
  const std::vector<BenchmarkedCase>& cases;
  const Diagnostics* found;
};

const Record<BenchmarkReportView>& benchmark_report_record();

}  // namespace kinestat
