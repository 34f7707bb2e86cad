#include "studies/synthesis/task/synthesis_findings.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/digit_limits.hpp"
#include "studies/synthesis/report/plane_text.hpp"
#include "studies/synthesis/report/synthesis_text.hpp"

namespace kinestat {

namespace {

bool has_usable(const SynthesisTask& task) {
  return !task.linkages.empty() && task.linkages.front().is_usable();
}

bool lacks_digits(const SynthesisTask& task) {
  return task.dyads && task.dyads->status == BurmesterStatus::no_digits;
}

// Which dyads of few positions are meant, the file may leave open, and so does a family.
bool asks_for_linkages(const SynthesisTask& task) {
  if (!task.dyads || (position_count(task.positions) < 5 && task.dyads->dyads.size() < 2)) {
    return false;
  }
  const bool is_family = task.dyads->status == BurmesterStatus::family &&
                         task.dyads->reason != Degeneracy::translation;
  return !is_family || task.dyads->dyads.size() >= 2;
}

// As a selection counts its choices.
SelectionCounts counts_of(const std::vector<SynthesisTask>& tasks) {
  SelectionCounts counts;
  for (const SynthesisTask& task : tasks) {
    for (const LinkageCandidate& one : task.linkages) {
      counts.add(one.defects);
    }
    if (task.linkages.empty() && task.dyads) {
      counts.add(task.dyads->dyads.size() < 2 ? Missing::dyads : Missing::kind);
    }
  }
  return counts;
}

bool has_no_choice(const SynthesisAnalysis& analysis) {
  return analysis.selection && analysis.selection->samples == 0;
}

std::string reason_of(const SynthesisAnalysis& analysis, const SelectionCounts& counts) {
  if (std::ranges::any_of(analysis.tasks, lacks_digits)) {
    return fmt::format("the positions are too close to each other for {} digits",
                       analysis.digits.value_or(kDoubleDigits));
  }
  if (has_no_choice(analysis)) {
    return "the curve of the points to choose from does not pass through their area";
  }
  return unusable_text(counts);
}

// What a limit alone stands in the way of.
std::string one_limit_hint(const SelectionCounts& counts) {
  const std::string limits = one_limit_text(counts);
  return limits.empty() ? "" : fmt::format("there would be {}; ", limits);
}

std::string hint_of(const SynthesisAnalysis& analysis, const SelectionCounts& counts) {
  for (const SynthesisTask& task : analysis.tasks) {
    if (!task.left_out.empty()) {
      return fmt::format("'linkage: any' has a usable {}", word_of(task.left_out.front().type));
    }
  }
  const bool has_no_digits = std::ranges::any_of(analysis.tasks, lacks_digits);
  if (has_no_digits) {
    return "write the positions with more digits, or give derivatives instead of positions that "
           "close in";
  }
  if (has_no_choice(analysis)) {
    return "widen the area of 'vary', or give other points";
  }
  return one_limit_hint(counts) +
         (analysis.selection
              ? "widen the ranges of 'vary', or the limits"
              : "move a position, or leave some of it open: 'kinestat help synthesis' has 'vary'") +
         "; the report has what comes nearest";
}

void warn_of_degenerate(const LinkageCandidate& best,
                        const SynthesisAnalysis& analysis,
                        Diagnostics& found) {
  constexpr double kBuildable = 100.0;
  constexpr double kFlat = 1.0 / 60.0;  // about a degree
  const FileUnits& units = analysis.description.units;
  const PlaneText plane(units);
  const SourceRange where = analysis.description.synthesis->where;
  if (!std::isfinite(analysis.limits.ratio) && best.ratio > kBuildable) {
    found.warning(
        "W0806",
        where,
        fmt::format("the shortest link of the best linkage is {} {unit} long, the longest "
                    "{} {unit}",
                    plane.length(best.longest / best.ratio),
                    plane.length(best.longest),
                    fmt::arg("unit", units.text(QuantityKind::length))),
        "bound their ratio: 'limits: {link_ratio: 10}'");
    return;
  }
  const double margin = best.best().full.margin();
  if (analysis.limits.full_transmission == 0.0 && best.best().turns_fully && margin < kFlat) {
    found.warning(
        "W0806",
        where,
        fmt::format("the best linkage turns fully, but folds almost flat: its transmission "
                    "angle comes within {} {} of a dead point",
                    plane.angle(margin),
                    units.text(QuantityKind::angle)),
        "keep it away from there: 'limits: {full_transmission_angle: 20 deg}'");
  }
}

}  // namespace

void add_usability_findings(const SynthesisAnalysis& analysis, Diagnostics& found) {
  const bool is_asked =
      analysis.selection || std::ranges::any_of(analysis.tasks, asks_for_linkages);
  if (!is_asked || std::ranges::any_of(analysis.tasks, has_usable)) {
    return;
  }
  const SelectionCounts counts = analysis.selection.value_or(counts_of(analysis.tasks));
  found.error("E0802",
              analysis.description.synthesis->where,
              fmt::format("no linkage is usable: {}", reason_of(analysis, counts)),
              hint_of(analysis, counts));
}

void warn_of_degenerate_best(const SynthesisAnalysis& analysis, Diagnostics& found) {
  const auto best = std::ranges::find_if(analysis.tasks, has_usable);
  if (analysis.selection && best != analysis.tasks.end()) {
    warn_of_degenerate(best->linkages.front(), analysis, found);
  }
}

}  // namespace kinestat
