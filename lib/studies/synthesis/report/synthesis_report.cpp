#include "studies/synthesis/report/synthesis_report.hpp"

#include <cmath>

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

std::optional<LimitsNeeded> find_limits_needed(const LinkageCandidate& candidate) {
  const Defects& defects = candidate.defects;
  if (defects.is_empty() || !defects.are_of_limits()) {
    return std::nullopt;
  }
  const auto unless_kept = [&](Defect defect, double needed) {
    return defects.has(defect) ? std::optional(needed) : std::nullopt;
  };
  LimitsNeeded needed;
  if (defects.has(Defect::grashof) && candidate.grashof) {
    needed.grashof = candidate.grashof->kind;
  }
  needed.is_any_linkage = defects.has(Defect::grashof) && !candidate.grashof;
  if (defects.has(Defect::other_circuit)) {
    needed.circuit = candidate.circuit;
    needed.is_any_circuit = !candidate.circuit;
  }
  needed.may_stop = defects.has(Defect::full_turn);
  if (candidate.outside > 0.0) {
    needed.outside = candidate.outside;
  }
  needed.transmission = unless_kept(Defect::transmission, candidate.margin());
  needed.full_transmission = unless_kept(Defect::full_transmission, candidate.best().full.margin());
  if (std::isfinite(candidate.ratio)) {  // a link without a length is within no limit
    needed.ratio = unless_kept(Defect::ratio, candidate.ratio);
  }
  needed.size = unless_kept(Defect::size, candidate.longest);
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
