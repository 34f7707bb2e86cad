// What a report of inputs says, whole.
#pragma once

#include "record/record.hpp"
#include "studies/inputs/report/inputs_report.hpp"

namespace kinestat {

struct InputsReportView {
  const std::string& file;  ///< path as the user gave it
  const MechanismDescription& description;
  const InputsAnalysis& inputs;
  const Diagnostics* found;
};

const Record<InputsReportView>& inputs_report_record();

}  // namespace kinestat
