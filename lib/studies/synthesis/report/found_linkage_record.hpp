// What reports say of a linkage that a synthesis found.
#pragma once

#include "record/record.hpp"
#include "studies/synthesis/curves/curve_record.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

struct FoundLinkageView {
  const SynthesisAnalysis& analysis;
  const SynthesisTask& task;
  const CurveWindow& window;
  std::size_t number = 0;  ///< of the linkage in the task

  const LinkageCandidate& candidate() const { return task.linkages[number]; }
};

/// The linkage with its limits, its coupler curve, its check and the file written for it.
const Record<FoundLinkageView>& found_linkage_record();

}  // namespace kinestat
