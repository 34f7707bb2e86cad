// What the report of a search for transmissions says, whole.
#pragma once

#include "record/record.hpp"
#include "studies/transmissions/report/transmission_analysis.hpp"

namespace kinestat {

struct TransmissionReportView {
  const std::string& file;
  const MechanismDescription& description;
  const TransmissionAnalysis& analysis;
  const Diagnostics* found;
};

const Record<TransmissionReportView>& transmission_report_record();

}  // namespace kinestat
