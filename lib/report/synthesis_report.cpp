#include "report/synthesis_report.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "report/report_parts.hpp"
#include "report/synthesis_csv.hpp"
#include "report/synthesis_json.hpp"
#include "report/synthesis_text.hpp"

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
                            candidate.defect == Defect::ratio || candidate.defect == Defect::size;
  if (!is_by_limits) {
    return std::nullopt;
  }
  LimitsNeeded needed;
  if (candidate.margin() < limits.transmission * (1.0 - kSameValue)) {
    needed.transmission = candidate.margin();
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
  if (forms.json || forms.json_line || forms.csv) {
    Json json = report_head(analysis.file, analysis.description);
    json["synthesis"] = synthesis_json(analysis);
    json["diagnostics"] = diagnostics_json(found);
    report.json = forms.json ? json.dump(2) + "\n" : std::string();
    report.json_line = forms.json_line ? json.dump() + "\n" : std::string();
    if (forms.csv) {
      report.csv.push_back(
          {.pass = "synthesis", .text = synthesis_csv(analysis, json["synthesis"])});
    }
  }
  if (forms.text) {
    report.text = synthesis_text(analysis);
  }
  return report;
}

}  // namespace kinestat
