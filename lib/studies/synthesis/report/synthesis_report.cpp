#include "studies/synthesis/report/synthesis_report.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "report/report_parts.hpp"
#include "studies/synthesis/report/synthesis_record.hpp"
#include "studies/synthesis/report/synthesis_text.hpp"

namespace kinestat {

std::vector<std::size_t> positions_with_lists(const SynthesisDescription& task) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < task.positions.size(); ++i) {
    if (task.positions[i].angles.size() > 1) {
      places.push_back(i);
    }
  }
  return places;
}

std::optional<LimitsNeeded> find_limits_needed(const LinkageCandidate& candidate,
                                               const LinkageLimits& limits) {
  const bool is_by_limits = candidate.defect == Defect::transmission ||
                            candidate.defect == Defect::full_transmission ||
                            candidate.defect == Defect::ratio || candidate.defect == Defect::size;
  if (!is_by_limits) {
    return std::nullopt;
  }
  LimitsNeeded needed;
  if (candidate.margin() < limits.transmission * (1.0 - kSameValue)) {
    needed.transmission = candidate.margin();
  }
  if (const double full = candidate.best().full.margin();
      full < limits.full_transmission * (1.0 - kSameValue)) {
    needed.full_transmission = full;
  }
  if (candidate.ratio > limits.ratio * (1.0 + kSameValue)) {
    needed.ratio = candidate.ratio;
  }
  if (candidate.longest > limits.size * (1.0 + kSameValue)) {
    needed.size = candidate.longest;
  }
  return needed;
}

FileReport make_synthesis_report(const SynthesisAnalysis& analysis,
                                 const ReportForms& forms,
                                 const Diagnostics& found) {
  FileReport report;
  const SynthesisReportView view{.analysis = analysis, .found = found};
  const FileUnits& units = analysis.description.units;
  add_json(synthesis_report_record, view, units, forms, report);
  if (forms.csv) {
    report.csv = tables_of(synthesis_report_record(),
                           view,
                           name_in_tables(analysis.file, analysis.description),
                           units,
                           MissingNumber::no_row);
  }
  if (forms.text) {
    report.text = synthesis_text(analysis);
  }
  return report;
}

}  // namespace kinestat
