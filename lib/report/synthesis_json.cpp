#include "report/synthesis_json.hpp"

#include <algorithm>
#include <string_view>

#include "core/utf8.hpp"
#include "math/digit_limits.hpp"
#include "report/linkage_json.hpp"
#include "report/plane_cubic_json.hpp"
#include "report/position_json.hpp"

namespace kinestat {

namespace {

std::string_view word_of(BurmesterStatus status) {
  switch (status) {
    case BurmesterStatus::solved:
      return "solved";
    case BurmesterStatus::family:
      return "family";
    case BurmesterStatus::no_digits:
      return "no_digits";
  }
  return "";
}

Json reason(Degeneracy why) {
  return why == Degeneracy::none ? Json(nullptr) : Json(word_of(why));
}

// Why samples fell out: each is counted once.
Json rejected_json(const SelectionCounts& counts) {
  Json result = object_of(kLackCount + kDefectCount);
  for (std::size_t i = 0; i < kLackCount; ++i) {
    result[word_of(static_cast<Lack>(i))] = counts.lacks[i];
  }
  for (std::size_t i = 1; i < kDefectCount; ++i) {
    result[word_of(static_cast<Defect>(i))] = counts.defects[i];
  }
  return result;
}

void add_counts(const SelectionCounts& counts, Json& result) {
  result["samples"] = counts.samples;
  result["with_linkage"] = counts.with_linkage;
  result["usable"] = counts.usable;
  result["rejected"] = rejected_json(counts);
}

// Which of the listed angles; empty where a file has no lists.
Json listed_angles_json(const std::vector<double>& angles, const SynthesisAnalysis& analysis) {
  const PlaneJson plane(analysis.description.units);
  Json result = Json::array();
  for (const std::size_t place : positions_with_lists(*analysis.description.synthesis)) {
    Json entry = object_of(2);
    entry["position"] = place + 1;
    entry["angle"] = plane.angle(angles[place]);
    result.push_back(std::move(entry));
  }
  return result;
}

Json selection_json(const SynthesisAnalysis& analysis) {
  if (!analysis.selection) {
    return nullptr;
  }
  Json result = object_of(5);
  add_counts(*analysis.selection, result);
  result["by_angles"] = Json::array();
  if (!positions_with_lists(*analysis.description.synthesis).empty()) {
    for (const AngleSelection& one : analysis.selections) {
      Json entry = object_of(6);
      entry["listed_angles"] = listed_angles_json(one.angles, analysis);
      add_counts(one.counts, entry);
      entry["first_task"] = one.first_task;
      result["by_angles"].push_back(std::move(entry));
    }
  }
  return result;
}

// Curves are drawn within some sizes of the task: the spread of its positions and poles.
CurveWindow window_of(const SynthesisTask& task, int count) {
  constexpr double kSizes = 4.0;
  Point sum(0.0, 0.0);
  for (const PositionJets& position : task.positions) {
    sum += origin(position);
  }
  const Point middle = sum / static_cast<double>(task.positions.size());
  double size = 0.0;
  for (const PositionJets& position : task.positions) {
    size = std::max(size, std::abs(origin(position) - middle));
    if (const auto pole = find_pole(position)) {
      size = std::max(size, std::abs(*pole - middle));
    }
  }
  return {.middle = middle, .radius = size > 0.0 ? kSizes * size : kSizes, .count = count};
}

// One task in the units of its file.
class TaskJson {
 public:
  TaskJson(const SynthesisAnalysis& analysis, const SynthesisTask& task)
      : analysis_(analysis),
        task_(task),
        plane_(analysis.description.units),
        window_(window_of(task, analysis.curve_count)),
        has_coupler_curves_(analysis.description.synthesis->curve_count.has_value()) {}

  Json run() const {
    Json result = object_of(14);
    std::vector<double> angles;
    for (const PositionJets& position : task_.positions) {
      angles.push_back(position.angle[0]);
    }
    result["listed_angles"] = listed_angles_json(angles, analysis_);
    if (task_.choice) {
      result["choice"] = choice_json(*task_.choice);
    }
    result["positions"] = Json::array();
    for (const PositionJets& position : task_.positions) {
      result["positions"].push_back(position_json(position, plane_));
    }
    if (task_.dyads) {
      add_dyads(*task_.dyads, result);
      result["linkages"] = Json::array();
      for (std::size_t i = 0; i < task_.linkages.size(); ++i) {
        result["linkages"].push_back(numbered_linkage_json(i));
      }
      result["left_out"] = Json::object();
      for (const LeftOutLinkages& one : task_.left_out) {
        result["left_out"][word_of(one.type)] = one.usable;
      }
    }
    if (task_.curves) {
      result["curves"] = curves_json(*task_.curves);
    }
    if (!task_.dyads && !task_.curves) {
      result["reason"] = reason(task_.special);
    }
    if (task_.straight_paths) {
      result["straight_paths"] = plane_.circle(*task_.straight_paths);
    }
    return result;
  }

 private:
  Json numbered_linkage_json(std::size_t number) const {
    const LinkageCandidate& candidate = task_.linkages[number];
    const bool is_written = number < task_.files.size() && !task_.files[number].empty();
    Json result = linkage_json(candidate, plane_);
    result["limits_needed"] = limits_needed_json(candidate);
    result["coupler_curve"] =
        has_coupler_curves_ ? coupler_curve_json(candidate,
                                                 pose_of(task_.positions[0]),
                                                 {.reach = window_.radius, .count = window_.count},
                                                 plane_)
                            : Json(nullptr);
    result["verification"] = number < task_.checks.size() && task_.checks[number]
                                 ? check_json(*task_.checks[number])
                                 : Json(nullptr);
    result["file"] = is_written ? Json(printable(task_.files[number])) : Json(nullptr);
    return result;
  }

  static Json check_json(const LinkageCheck& check) {
    Json result = object_of(4);
    result["reached"] = check.reached;
    result["in_order"] = check.passes_in_order;
    result["worst"] = number(check.worst);
    result["agrees"] = check.agrees;
    return result;
  }

  Json limits_needed_json(const LinkageCandidate& candidate) const {
    const auto needed = find_limits_needed(candidate, analysis_.limits);
    if (!needed) {
      return nullptr;
    }
    Json result = object_of(3);
    result["transmission_angle"] =
        needed->transmission ? plane_.angle(*needed->transmission) : Json(nullptr);
    result["link_ratio"] = number(needed->ratio);
    result["size"] = needed->size ? plane_.length(*needed->size) : Json(nullptr);
    return result;
  }

  Json choice_json(const SynthesisChoice& choice) const {
    Json result = object_of(8);
    result["m"] = number(choice.m);
    result["free_point"] = choice.free_point ? plane_.point(*choice.free_point) : Json(nullptr);
    const auto& freedom = choice.freedom;
    result["s"] = freedom ? plane_.length(freedom->s) : Json(nullptr);
    result["tau"] = freedom ? number(freedom->tau) : Json(nullptr);
    result["tau_2"] = freedom ? number(freedom->tau_2) : Json(nullptr);
    return result;
  }

  void add_dyads(const BurmesterSolution& solution, Json& result) const {
    result["status"] = word_of(solution.status);
    result["reason"] = reason(solution.reason);
    result["digits"] = number(solution.digits);
    result["flatness"] = number(solution.flatness);
    result["imaginary_dyads"] = solution.imaginary_count;
    result["dyads"] = Json::array();
    for (const Dyad& dyad : solution.dyads) {
      result["dyads"].push_back(dyad_json(dyad, plane_));
    }
    const bool has_nearest = solution.dyads.empty() && solution.nearest;
    result["nearest_dyad"] = has_nearest ? dyad_json(*solution.nearest, plane_) : Json(nullptr);
  }

  Json curves_json(const FourPositionCurves& curves) const {
    const bool is_solved = curves.status == BurmesterStatus::solved;
    const auto cubic = [&](const PlaneCubic& one, std::span<const PositionJets> positions) {
      return is_solved ? cubic_json(one, window_, plane_, positions) : Json(nullptr);
    };
    Json result = object_of(8);
    result["status"] = word_of(curves.status);
    result["reason"] = reason(curves.reason);
    result["digits"] = number(curves.digits);
    result["flatness"] = number(curves.flatness);
    result["circle_points"] = cubic(curves.circle_points, task_.positions);
    result["centre_points"] = cubic(curves.centre_points, {});
    result["slider"] = curves.slider ? dyad_json(*curves.slider, plane_) : Json(nullptr);
    result["inverted_slider"] =
        curves.inverted_slider ? dyad_json(*curves.inverted_slider, plane_) : Json(nullptr);
    return result;
  }

  const SynthesisAnalysis& analysis_;
  const SynthesisTask& task_;
  PlaneJson plane_;
  CurveWindow window_;
  bool has_coupler_curves_ = false;
};

}  // namespace

Json synthesis_json(const SynthesisAnalysis& analysis) {
  Json result = object_of(4);
  result["form"] = analysis.form;
  result["working_digits"] = analysis.digits.value_or(kDoubleDigits);
  result["selection"] = selection_json(analysis);
  result["tasks"] = Json::array();
  for (const SynthesisTask& task : analysis.tasks) {
    result["tasks"].push_back(TaskJson(analysis, task).run());
  }
  return result;
}

}  // namespace kinestat
