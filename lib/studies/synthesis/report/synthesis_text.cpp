#include "studies/synthesis/report/synthesis_text.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "core/digit_limits.hpp"
#include "core/one_digit.hpp"
#include "report/report_parts.hpp"
#include "studies/synthesis/report/linkage_text.hpp"
#include "studies/synthesis/report/plane_text.hpp"

namespace kinestat {

namespace {

std::string_view phrase_of(Missing missing) {
  switch (missing) {
    case Missing::motion:
      return "contradictory positions";
    case Missing::dyads:
      return "fewer than two real dyads";
    case Missing::kind:
      return "no linkage of the kind that 'linkage' requests";
  }
  return "";
}

std::string rejected_text(const SelectionCounts& counts) {
  const std::string reasons = unusable_text(counts);
  const std::string one_limit = one_limit_text(counts);
  return (reasons.empty() ? "" : fmt::format("not usable: {}\n", reasons)) +
         (one_limit.empty() ? ""
                            : fmt::format("usable without one of the limits: {}\n", one_limit));
}

bool is_usable(const SynthesisTask& task) {
  return !task.linkages.empty() && task.linkages.front().is_usable();
}

std::string selection_text(const SelectionCounts& counts, std::span<const SynthesisTask> tasks) {
  if (counts.samples == 0) {
    return "nothing to choose from: the curve of these points does not pass through the area of "
           "'vary'\n";
  }
  return fmt::format("{} choices tried, {} with a linkage, {} with a usable one\n{}{}",
                     counts.samples,
                     counts.with_linkage,
                     counts.usable,
                     rejected_text(counts),
                     counts.usable == 1         ? "the best is:\n"
                     : counts.usable > 1        ? "the best, with similar ones merged:\n"
                     : tasks.empty()            ? ""
                     : is_usable(tasks.front()) ? "between them there is:\n"
                                                : "the nearest is:\n");
}

// Which of the listed angles: "angle 70 of position 3"; empty where a file has no lists.
std::string listed_angles_text(const std::vector<double>& angles,
                               const SynthesisAnalysis& analysis,
                               const PlaneText& plane) {
  std::vector<std::string> texts;
  for (const std::size_t place : positions_with_lists(*analysis.description.synthesis)) {
    texts.push_back(fmt::format("angle {} of position {}", plane.angle(angles[place]), place + 1));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

// One task in the units of its file.
class TaskText {
 public:
  TaskText(const SynthesisAnalysis& analysis, const SynthesisTask& task)
      : analysis_(analysis), task_(task), plane_(analysis.description.units) {}

  TextBlocks run() const {
    TextBlocks text("\n" + choice_text() + positions_text(task_, plane_));
    if (task_.dyads) {
      text += dyads_blocks(task_, analysis_.digits.value_or(kDoubleDigits), plane_);
      text += free_dyads() == 0 ? linkages_blocks(task_, analysis_.limits, plane_) : TextBlocks();
    }
    if (task_.curves) {
      text += curves_text(*task_.curves);
    }
    if (!task_.dyads && analysis_.limits.function && !is_family()) {
      return text += function_offer_text();
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
      text += "any point is a circle point, with its centres on a line\n";
    }
    text += offer_text();
    return text;
  }

 private:
  // How many of two are neither given nor chosen, of positions that leave a choice.
  int free_dyads() const {
    const int given = task_.dyads ? static_cast<int>(task_.dyads->dyads.size()) : 0;
    return position_count(task_.positions) > 4 ? 0 : std::max(2 - given, 0);
  }

  bool is_family() const {
    return task_.special != Degeneracy::none ||
           (task_.curves && task_.curves->status != BurmesterStatus::solved);
  }

  // Few positions leave dyads to choose from; a family that holds otherwise does not.
  std::string offer_text() const {
    const auto& vary = analysis_.description.synthesis->vary;
    const bool are_chosen = std::ranges::any_of(
        vary, [](const SynthesisRange& range) { return chooses_dyads(range.which); });
    const int free = free_dyads();
    if (free == 0 || is_family() || are_chosen) {
      return "";
    }
    const std::string_view what = free == 1 ? "one dyad is free" : "two dyads are free";
    if (position_count(task_.positions) == 2) {
      return fmt::format(
          "{}; to have a linkage, give both with their pivots:\n"
          "  dyads: [{{circle_point: [x, y]}}, {{circle_point: [x, y]}}]\n"
          "where a message says on which line the other pivot lies\n",
          what);
    }
    const std::string end = plane_.length(half_width());
    return fmt::format(
               "{1}; to select linkages, say where their circle points may lie, or their "
               "centre points:\n"
               "  vary: {{circle_points: {{from: [-{0}, -{0}], to: [{0}, {0}]}}}}\n"
               "or give pivots:\n"
               "  dyads: [{{centre_point: [x, y]}}, {{centre_point: [x, y]}}]\n",
               end,
               what) +
           (free == 2 ? next_order_text() : "");
  }

  // Four positions with a pole: one condition more on the path of E makes five.
  std::string next_order_text() const {
    const auto& positions = analysis_.description.synthesis->positions;
    const auto with_pole = std::ranges::find_if(
        positions, [](const PositionDescription& one) { return one.pole.has_value(); });
    if (with_pole == positions.end() || position_count(task_.positions) != 4) {
      return "";
    }
    const auto place = static_cast<std::size_t>(with_pole - positions.begin());
    const PositionJets& position = task_.positions[place];
    const auto pole = find_pole(position);
    const int order = with_pole->order() + 1;
    return fmt::format(
        "or prescribe the path of 'at' in position {} to one order more, and let vary what that "
        "leaves open:\n"
        "  curvature: {{centre: [x, y]}}{}{}\n"
        "  {}\n",
        place + 1,
        order > 3 ? ", stationary: true" : "",
        order > 4 ? ", burmester: true" : "",
        example_of_ranges(
            order, pole ? std::abs(*pole - origin(position)) / plane_.unit_of_length() : 0.0));
  }

  // What a function leaves to choose.
  std::string function_offer_text() const {
    const int count = position_count(task_.positions);
    if (count == 2) {
      return "the circle point of the input may be any point, and that of the output lies on a "
             "line;\nto have a linkage, give 'circle_point' of both, where a message says on which "
             "line\n";
    }
    const AngleFunction& function = *analysis_.limits.function;
    const double unit = plane_.unit_of_length();
    const double ground = std::abs(function.output_pivot - function.input_pivot);
    const std::string end = plane_.length(unit * round_up_to_one_digit(ground / unit));
    return fmt::format(
        "{1}; to select linkages, say where the circle point of the input may lie:\n"
        "  vary: {{circle_points: {{from: [-{0}, -{0}], to: [{0}, {0}]}}}}\n"
        "or give 'circle_point' of one of the links\n",
        end,
        count == 4 ? "the circle point of the input may be any point of its curve, and that of "
                     "the output follows"
                   : "the circle point of the input may be any point, and that of the output "
                     "follows");
  }

  // About the size of the task, for an example.
  double half_width() const {
    const Point first = origin(task_.positions.front());
    double size = 0.0;
    for (const PositionJets& position : task_.positions) {
      size = std::max(size, std::abs(origin(position) - first));
      if (const auto pole = find_pole(position)) {
        size = std::max(size, std::abs(*pole - first));
      }
    }
    const double unit = plane_.unit_of_length();
    return size > 0.0 ? unit * round_up_to_one_digit(2.0 * size / unit) : unit;
  }

  // What tells this task from the others of the file; its number is that of files and other forms.
  std::string choice_text() const {
    std::vector<double> angles;
    for (const PositionJets& position : task_.positions) {
      angles.push_back(position.angle[0]);
    }
    std::vector<std::string> texts = {listed_angles_text(angles, analysis_, plane_)};
    if (task_.choice) {
      const auto& [m, free_point, freedom] = *task_.choice;
      texts.push_back(m ? "m " + format_short(*m) : "");
      texts.push_back(free_point ? "free_point " + plane_.point(*free_point) : "");
      texts.push_back(freedom ? freedom_text(*freedom) : "");
    }
    std::erase(texts, "");
    if (analysis_.tasks.size() > 1) {
      const std::string number = fmt::format("task {}", &task_ - analysis_.tasks.data());
      return texts.empty() ? number + "\n"
                           : fmt::format("{}: {}\n", number, fmt::join(texts, ", "));
    }
    return texts.empty() ? "" : fmt::format("{}\n", fmt::join(texts, ", "));
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
    if (analysis_.limits.function) {
      return curve_text("circle points of the input", curves.circle_points) +
             curve_text("circle points of the output", curves.centre_points);
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

std::string unusable_text(const SelectionCounts& counts) {
  std::vector<std::string> reasons;
  for (std::size_t i = 0; i < kMissingCount; ++i) {
    if (counts.missing[i] > 0) {
      reasons.push_back(
          fmt::format("{} ({})", phrase_of(static_cast<Missing>(i)), counts.missing[i]));
    }
  }
  for (std::size_t i = 1; i < kDefectCount; ++i) {
    if (counts.defects[i] > 0) {
      reasons.push_back(
          fmt::format("{} ({})", phrase_of(static_cast<Defect>(i)), counts.defects[i]));
    }
  }
  return fmt::format("{}", fmt::join(reasons, ", "));
}

std::string one_limit_text(const SelectionCounts& counts) {
  std::vector<std::string> limits;
  for (std::size_t i = 0; i < kDefectCount; ++i) {
    if (counts.one_limit[i] > 0) {
      limits.push_back(
          fmt::format("{} without '{}'", counts.one_limit[i], limit_of(static_cast<Defect>(i))));
    }
  }
  return fmt::format("{}", fmt::join(limits, ", "));
}

TextBlocks synthesis_text(const SynthesisAnalysis& analysis) {
  TextBlocks text(title_text(analysis.file, analysis.description));
  return text += synthesis_blocks(analysis);
}

TextBlocks synthesis_blocks(const SynthesisAnalysis& analysis) {
  const FileUnits& units = analysis.description.units;
  TextBlocks text(fmt::format("  {} {}, lengths in {}, angles in {}{}\n",
                              analysis.limits.function ? "function" : "task",
                              analysis.form,
                              units.text(QuantityKind::length),
                              units.text(QuantityKind::angle),
                              analysis.digits ? fmt::format(", {} digits", *analysis.digits) : ""));
  const PlaneText plane(units);
  const auto add_tasks = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      text += TaskText(analysis, analysis.tasks[i]).run();
    }
  };
  const std::size_t count = analysis.tasks.size();
  for (std::size_t i = 0; i < analysis.selections.size(); ++i) {
    const AngleSelection& one = analysis.selections[i];
    const bool is_last = i + 1 == analysis.selections.size();
    const std::size_t end = is_last ? count : analysis.selections[i + 1].first_task;
    const std::string angles = listed_angles_text(one.angles, analysis, plane);
    text += (angles.empty() ? "" : "\n" + angles + ": ") +
            selection_text(one.counts,
                           std::span(analysis.tasks).subspan(one.first_task, end - one.first_task));
    add_tasks(one.first_task, end);
  }
  if (analysis.selections.empty()) {
    add_tasks(0, count);
  }
  return text;
}

}  // namespace kinestat
