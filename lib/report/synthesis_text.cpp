#include "report/synthesis_text.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "math/digit_limits.hpp"
#include "report/analysis_text.hpp"
#include "report/in_units.hpp"
#include "report/numbers.hpp"
#include "report/table.hpp"

namespace kinestat {

namespace {

std::string_view phrase_of(Degeneracy reason) {
  switch (reason) {
    case Degeneracy::none:
      return "";
    case Degeneracy::translation:
      return "the plane does not turn from position to position: every point is a circle point, or "
             "none";
    case Degeneracy::repeated_position:
      return "a position is there twice, so that fewer than five remain";
    case Degeneracy::dependent:
      return "the conditions of the positions follow from each other";
    case Degeneracy::straight_paths:
      return "a whole circle of points moves on straight lines";
    case Degeneracy::sliding_lines:
      return "a whole pencil of lines slides on fixed points";
    case Degeneracy::shared_line:
    case Degeneracy::shared_conic:
      return "a whole curve of points stays on circles";
  }
  return "";
}

std::string_view phrase_of(Defect defect) {
  switch (defect) {
    case Defect::none:
      return "usable";
    case Defect::circuit:
      return "circuit defect";
    case Defect::branch:
      return "branch defect";
    case Defect::order:
      return "order defect";
    case Defect::transmission:
      return "transmission angle too small";
    case Defect::ratio:
      return "link ratio too large";
    case Defect::size:
      return "too large";
  }
  return "";
}

class SynthesisText {
 public:
  explicit SynthesisText(const SynthesisAnalysis& analysis)
      : analysis_(analysis), in_(analysis.description.units, {}) {}

  std::string run() {
    std::string text =
        fmt::format("{}  task {}, lengths in {}, angles in {}{}\n",
                    title_text(analysis_.file, analysis_.description),
                    analysis_.form,
                    in_.units().text(QuantityKind::length),
                    in_.units().text(QuantityKind::angle),
                    analysis_.digits ? fmt::format(", {} digits", *analysis_.digits) : "");
    if (analysis_.selection) {
      text += selection_text(*analysis_.selection);
    }
    for (const SynthesisTask& task : analysis_.tasks) {
      zero_ = zero_length(task);
      text += task_text(task);
    }
    return text;
  }

 private:
  std::string length(double value) const { return format_short(in_.length(snap(value, zero_))); }

  std::string angle(double value) const { return format_short(in_.angle(value)); }

  std::string point(const Point& p) const {
    return fmt::format("({}, {})", length(p.real()), length(p.imag()));
  }

  static std::string selection_text(const SelectionCounts& counts) {
    return fmt::format("{} choices tried, {} with a linkage, {} with a usable one{}\n",
                       counts.samples,
                       counts.with_linkage,
                       counts.usable,
                       counts.usable > 0         ? "; the best are:"
                       : counts.with_linkage > 0 ? "; the nearest is:"
                                                 : "");
  }

  std::string task_text(const SynthesisTask& task) const {
    std::string text = "\n";
    if (task.choice) {
      const std::string choice = choice_text(task);
      text += choice + (choice.empty() ? "" : "\n");
    } else if (analysis_.tasks.size() > 1) {
      text += "angles";
      for (const PositionJets& position : task.positions) {
        text += " " + angle(position.angle[0]);
      }
      text += "\n";
    }
    if (task.dyads) {
      text += dyads_text(*task.dyads) + linkages_text(task);
    }
    if (task.curves) {
      text += curves_text(*task.curves);
    }
    if (task.straight_paths) {
      text += fmt::format(
          "three positions: any point is a circle point; those of the circle about "
          "{} with radius {} move on straight lines\n",
          point(task.straight_paths->centre),
          length(task.straight_paths->radius));
    } else if (!task.dyads && !task.curves) {
      text += "any point is a circle point\n";
    }
    return text;
  }

  std::string choice_text(const SynthesisTask& task) const {
    const SynthesisChoice& choice = *task.choice;
    std::string text = choice.m ? "m " + format_short(*choice.m) : "";
    text += choice.m && choice.free_point ? ", " : "";
    text += choice.free_point ? "free_point " + point(*choice.free_point) : "";
    text += choice.freedom ? freedom_text(task) : "";
    return text;
  }

  std::string freedom_text(const SynthesisTask& task) const {
    const EffectiveFreedom& freedom = *task.choice->freedom;
    const int order = std::ranges::max_element(task.positions, {}, &PositionJets::order)->order();
    std::string text = "s " + length(freedom.s);
    text += order > 3 ? ", tau " + format_short(freedom.tau) : "";
    text += order > 4 ? ", tau_2 " + format_short(freedom.tau_2) : "";
    return text;
  }

  std::string dyads_text(const BurmesterSolution& solution) const {
    if (solution.status == BurmesterStatus::no_digits) {
      return fmt::format("no dyads: the positions are too close to each other for {} digits\n",
                         analysis_.digits.value_or(kDoubleDigits));
    }
    std::string text;
    if (solution.status == BurmesterStatus::family) {
      text += fmt::format("a family of dyads: {}\n", phrase_of(solution.reason));
    }
    Table table({"dyad", "circle point", "centre", "length", "digits"});
    for (std::size_t i = 0; i < solution.dyads.size(); ++i) {
      add_dyad(solution.dyads[i], i, table);
    }
    text += table.is_empty() ? "no real dyad\n" : table.text("");
    if (solution.imaginary_count > 0) {
      text += fmt::format("{} dyads are not real\n", solution.imaginary_count);
    }
    return text;
  }

  void add_dyad(const Dyad& dyad, std::size_t index, Table& table) const {
    std::string kind = dyad.multiplicity > 1 ? " double" : "";
    std::string length_text = length(dyad.length);
    if (dyad.kind != DyadKind::crank) {
      kind += dyad.kind == DyadKind::slider ? " slider" : " inverted slider";
      length_text = fmt::format("along ({}, {})",
                                format_short(dyad.direction.real()),
                                format_short(dyad.direction.imag()));
    }
    table.add({fmt::format("{}{}", index, kind),
               point(dyad.circle_point),
               point(dyad.centre_point),
               length_text,
               fmt::format("{:.0f}", dyad.digits)});
  }

  std::string linkages_text(const SynthesisTask& task) const {
    if (task.dyads->status == BurmesterStatus::no_digits) {
      return "";
    }
    if (task.linkages.empty()) {
      return task.dyads->dyads.size() < 2 ? "no linkage: that takes two real dyads\n"
                                          : "no linkage of the kind that 'linkage' asks for\n";
    }
    Table table({"linkage", "dyads", "drive", "verdict", "margin", "full turn", "ratio", "class"});
    for (const LinkageCandidate& candidate : task.linkages) {
      const DriveVerdict& best = candidate.best();
      const std::size_t drive = candidate.best_drive == Drive::one ? 0 : 1;
      table.add({std::string(word_of(candidate.linkage.type())),
                 fmt::format("{} {}", candidate.dyads[0], candidate.dyads[1]),
                 fmt::format("{}", candidate.dyads[drive]),
                 std::string(phrase_of(candidate.defect)),
                 best.working_arc ? angle(candidate.margin()) : "",
                 best.turns_fully ? "yes" : "no",
                 format_short(candidate.ratio),
                 candidate.grashof ? std::string(word_of(candidate.grashof->kind)) : ""});
    }
    std::string text = "\n" + table.text("");
    if (task.linkages.front().defect != Defect::none) {
      text += "no linkage is usable; the first one is the nearest\n";
    }
    return text;
  }

  std::string curves_text(const FourPositionCurves& curves) const {
    if (curves.status == BurmesterStatus::no_digits) {
      return fmt::format("no curves: the positions are too close to each other for {} digits\n",
                         kDoubleDigits);
    }
    if (curves.status == BurmesterStatus::family) {
      return fmt::format("a family of dyads: {}\n", phrase_of(curves.reason));
    }
    std::string text = curve_text("circle points", curves.circle_points) +
                       curve_text("centre points", curves.centre_points);
    if (curves.slider) {
      text += fmt::format("slider at {}\n", point(curves.slider->circle_point));
    }
    if (curves.inverted_slider) {
      text +=
          fmt::format("inverted slider through {}\n", point(curves.inverted_slider->centre_point));
    }
    return text;
  }

  std::string curve_text(std::string_view what, const PlaneCubic& cubic) const {
    const auto focus = cubic.focus();
    return fmt::format(
        "curve of {}: {}\n", what, focus ? "focus " + point(*focus) : std::string("a conic"));
  }

  const SynthesisAnalysis& analysis_;
  InUnits in_;
  double zero_ = 0.0;  // below it a length of the task is rounding [m]
};

}  // namespace

std::string synthesis_text(const SynthesisAnalysis& analysis) {
  return SynthesisText(analysis).run();
}

}  // namespace kinestat
