// What the report of a synthesis says, whole.
#pragma once

#include "core/diagnostic.hpp"
#include "record/record.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

struct SynthesisReportView {
  const SynthesisAnalysis& analysis;
  const Diagnostics& found;
};

const Record<SynthesisReportView>& synthesis_report_record();

}  // namespace kinestat
