// What reports say of a selection over the ranges of a synthesis task.
#pragma once

#include "record/record.hpp"
#include "studies/synthesis/report/synthesis_report.hpp"

namespace kinestat {

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
