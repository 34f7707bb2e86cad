// What a report of tolerances says, whole.
#pragma once

#include "record/record.hpp"
#include "studies/tolerance/report/tolerance_report.hpp"

namespace kinestat {

struct ToleranceReportView {
  const std::string& file;  ///< path as the user gave it
  const MechanismDescription& description;
  const FoundTolerance& answer;
  const Diagnostics* found;
};

const Record<ToleranceReportView>& tolerance_report_record();

}  // namespace kinestat
