// What the report of a synthesis says, whole.
#pragma once

#include "core/diagnostic.hpp"
#include "record/record.hpp"
#include "studies/synthesis/curves/curve_record.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

struct SynthesisReportView {
  const SynthesisAnalysis& analysis;
  const Diagnostics& found;
};

const Record<SynthesisReportView>& synthesis_report_record();

/// What reports say of a linkage that a synthesis found.
struct FoundLinkageView {
  const SynthesisAnalysis& analysis;
  const SynthesisTask& task;
  const CurveWindow& window;
  std::size_t number = 0;  ///< of the linkage in the task

  const LinkageCandidate& candidate() const { return task.linkages[number]; }
};

/// The linkage with its limits, its coupler curve, its check and the file written for it.
const Record<FoundLinkageView>& found_linkage_record();

/// One of the angles that a file lists.
struct ListedAngle {
  std::size_t place = 0;  ///< of its position, from 0
  double angle = 0.0;     ///< [rad]
};

const Record<ListedAngle>& listed_angle_record();

/// Which of the listed angles stand in `angles`, those of all positions [rad]; none where a file
/// has no lists.
void emit_listed_angles(const std::vector<double>& angles,
                        const SynthesisAnalysis& analysis,
                        const Each<ListedAngle>& each);

/// An analysis that has a selection.
struct SelectionView {
  const SynthesisAnalysis& analysis;
};

const Record<SelectionView>& selection_record();

/// What was chosen for the ranges.
const Record<SynthesisChoice>& choice_record();

}  // namespace kinestat
