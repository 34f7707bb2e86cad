// What a report of mobility says, whole.
#pragma once

#include "record/record.hpp"
#include "studies/mobility/report/mobility_report.hpp"

namespace kinestat {

struct MobilityReportView {
  const std::string& file;  ///< path as the user gave it
  const MechanismDescription& description;
  const MobilityAnalysis& analysis;
  const Diagnostics* found;
};

const Record<MobilityReportView>& mobility_report_record();

}  // namespace kinestat
