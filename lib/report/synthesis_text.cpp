#include "report/synthesis_text.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "math/digit_limits.hpp"
#include "report/analysis_text.hpp"
#include "report/linkage_text.hpp"
#include "report/position_text.hpp"

namespace kinestat {

namespace {

std::string selection_text(const SelectionCounts& counts) {
  return fmt::format("{} choices tried, {} with a linkage, {} with a usable one{}\n",
                     counts.samples,
                     counts.with_linkage,
                     counts.usable,
                     counts.usable > 0         ? "; the best are:"
                     : counts.with_linkage > 0 ? "; the nearest is:"
                                               : "");
}

// One task in the units of its file.
class TaskText {
 public:
  TaskText(const SynthesisAnalysis& analysis, const SynthesisTask& task)
      : analysis_(analysis), task_(task), plane_(analysis.description.units, zero_length(task)) {}

  std::string run() const {
    std::string text = "\n" + choice_text() + positions_text(task_, plane_);
    if (task_.dyads) {
      text += dyads_text(task_, analysis_.digits.value_or(kDoubleDigits), plane_) +
              linkages_text(task_, plane_);
    }
    if (task_.curves) {
      text += curves_text(*task_.curves);
    }
    if (!task_.dyads && !task_.curves && task_.special != Degeneracy::none) {
      text += family_text(task_.special, task_.positions);
    } else if (task_.straight_paths) {
      text += fmt::format(
          "three positions: any point is a circle point; those of the circle about "
          "{} with radius {} move on straight lines\n",
          plane_.point(task_.straight_paths->centre),
          plane_.length(task_.straight_paths->radius));
    } else if (!task_.dyads && !task_.curves) {
      text += "any point is a circle point\n";
    }
    return text;
  }

 private:
  // What tells this task from the others of the file.
  std::string choice_text() const {
    if (task_.choice) {
      const auto& [m, free_point, freedom] = *task_.choice;
      const std::string text =
          fmt::format("{}{}{}{}",
                      m ? "m " + format_short(*m) : "",
                      m && free_point ? ", " : "",
                      free_point ? "free_point " + plane_.point(*free_point) : "",
                      freedom ? freedom_text(*freedom) : "");
      return text + (text.empty() ? "" : "\n");
    }
    if (analysis_.tasks.size() < 2) {
      return "";
    }
    std::string text = "angles";
    for (const PositionJets& position : task_.positions) {
      text += " " + plane_.angle(position.angle[0]);
    }
    return text + "\n";
  }

  std::string freedom_text(const EffectiveFreedom& freedom) const {
    const int order = std::ranges::max_element(task_.positions, {}, &PositionJets::order)->order();
    std::string text = "s " + plane_.length(freedom.s);
    text += order > 3 ? ", tau " + format_short(freedom.tau) : "";
    text += order > 4 ? ", tau_2 " + format_short(freedom.tau_2) : "";
    return text;
  }

  std::string curves_text(const FourPositionCurves& curves) const {
    if (curves.status == BurmesterStatus::no_digits) {
      return fmt::format("no curves: the positions are too close to each other for {} digits\n",
                         kDoubleDigits);
    }
    if (curves.status == BurmesterStatus::family) {
      return family_text(curves.reason, task_.positions);
    }
    std::string text = curve_text("circle points", curves.circle_points) +
                       curve_text("centre points", curves.centre_points);
    if (curves.slider) {
      text += fmt::format("slider at {}\n", plane_.point(curves.slider->circle_point));
    }
    if (curves.inverted_slider) {
      text += fmt::format("inverted slider through {}\n",
                          plane_.point(curves.inverted_slider->centre_point));
    }
    return text;
  }

  std::string curve_text(std::string_view what, const PlaneCubic& cubic) const {
    const auto focus = cubic.focus();
    const auto circle = cubic.circle();
    return fmt::format("curve of {}: {}\n",
                       what,
                       focus          ? "focus " + plane_.point(*focus)
                       : circle       ? fmt::format("a circle about {} with radius {}",
                                              plane_.point(circle->centre),
                                              plane_.length(circle->radius))
                       : cubic.line() ? std::string("a straight line")
                                      : std::string("a conic"));
  }

  const SynthesisAnalysis& analysis_;
  const SynthesisTask& task_;
  PlaneText plane_;
};

}  // namespace

std::string synthesis_text(const SynthesisAnalysis& analysis) {
  const FileUnits& units = analysis.description.units;
  std::string text =
      fmt::format("{}  task {}, lengths in {}, angles in {}{}\n",
                  title_text(analysis.file, analysis.description),
                  analysis.form,
                  units.text(QuantityKind::length),
                  units.text(QuantityKind::angle),
                  analysis.digits ? fmt::format(", {} digits", *analysis.digits) : "");
  if (analysis.selection) {
    text += selection_text(*analysis.selection);
  }
  for (const SynthesisTask& task : analysis.tasks) {
    text += TaskText(analysis, task).run();
  }
  return text;
}

}  // namespace kinestat
