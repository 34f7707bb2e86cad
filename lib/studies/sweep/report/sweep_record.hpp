// What is told of a sweep in a file beside its rows.
#pragma once

#include "record/record.hpp"
#include "studies/sweep/report/sweep_metadata.hpp"

namespace kinestat {

const Record<Criterion>& criterion_record();
const Record<SampleChoice>& sample_record();

struct SweepSummaryView {
  const SweepMetadata& metadata;
  const SweepCounts& counts;
};

const Record<SweepSummaryView>& sweep_summary_record();

}  // namespace kinestat
