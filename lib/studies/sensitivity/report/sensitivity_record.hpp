// What a report of sensitivities says, whole.
#pragma once

#include "record/record.hpp"
#include "studies/sensitivity/report/sensitivity_report.hpp"

namespace kinestat {

struct SensitivityReportView {
  const std::string& file;  ///< path as the user gave it
  const MechanismDescription& description;
  const std::vector<SensitivityParameter>& parameters;
  const std::vector<CaseSensitivity>& cases;
  const Diagnostics* found;
};

const Record<SensitivityReportView>& sensitivity_report_record();

}  // namespace kinestat
