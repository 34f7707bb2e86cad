#include "report/synthesis_json.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "math/digit_limits.hpp"
#include "report/in_units.hpp"
#include "synthesis/cubic_branches.hpp"
#include "synthesis/path_curvature.hpp"

namespace kinestat {

namespace {

std::string_view word_of(DyadKind kind) {
  switch (kind) {
    case DyadKind::crank:
      return "crank";
    case DyadKind::slider:
      return "slider";
    case DyadKind::inverted_slider:
      return "inverted_slider";
  }
  return "";
}

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

std::string_view word_of(Passage passage) {
  switch (passage) {
    case Passage::none:
      return "none";
    case Passage::increasing:
      return "increasing";
    case Passage::decreasing:
      return "decreasing";
  }
  return "";
}

class SynthesisJson {
 public:
  explicit SynthesisJson(const SynthesisAnalysis& analysis)
      : analysis_(analysis), in_(analysis.description.units, {}) {}

  Json run() {
    Json result = object_of(4);
    result["form"] = analysis_.form;
    result["working_digits"] = analysis_.digits.value_or(kDoubleDigits);
    result["selection"] = Json(nullptr);
    if (analysis_.selection) {
      result["selection"] = object_of(3);
      result["selection"]["samples"] = analysis_.selection->samples;
      result["selection"]["with_linkage"] = analysis_.selection->with_linkage;
      result["selection"]["usable"] = analysis_.selection->usable;
    }
    result["tasks"] = Json::array();
    for (const SynthesisTask& task : analysis_.tasks) {
      zero_ = zero_length(task);
      result["tasks"].push_back(task_json(task));
    }
    return result;
  }

 private:
  Json length(double value) const { return number(in_.length(snap(value, zero_))); }

  Json angle(double value) const { return number(in_.angle(value)); }

  Json point(const Point& p) const { return Json::array({length(p.real()), length(p.imag())}); }

  static Json direction(const Point& p) {
    return Json::array({number(p.real()), number(p.imag())});
  }

  Json per_length(const std::optional<double>& value) const {
    return value ? number(*value * in_.units().factor(QuantityKind::length)) : Json(nullptr);
  }

  Json task_json(const SynthesisTask& task) const {
    Json result = object_of(8);
    if (task.choice) {
      result["choice"] = object_of(8);
      result["choice"]["m"] = number(task.choice->m);
      result["choice"]["free_point"] =
          task.choice->free_point ? point(*task.choice->free_point) : Json(nullptr);
      const auto& freedom = task.choice->freedom;
      result["choice"]["s"] = freedom ? length(freedom->s) : Json(nullptr);
      result["choice"]["tau"] = freedom ? number(freedom->tau) : Json(nullptr);
      result["choice"]["tau_2"] = freedom ? number(freedom->tau_2) : Json(nullptr);
    }
    result["positions"] = Json::array();
    for (const PositionJets& position : task.positions) {
      result["positions"].push_back(position_json(position));
    }
    if (task.dyads) {
      add_dyads(*task.dyads, result);
      result["linkages"] = Json::array();
      for (const LinkageCandidate& candidate : task.linkages) {
        result["linkages"].push_back(linkage_json(candidate));
      }
    }
    if (task.curves) {
      result["curves"] = curves_json(*task.curves, task);
    }
    if (task.straight_paths) {
      result["straight_paths"] = circle_json(*task.straight_paths);
    }
    return result;
  }

  Json position_json(const PositionJets& position) const {
    Json result = object_of(4);
    result["at"] = point(origin(position));
    result["angle"] = angle(position.angle[0]);
    result["derivatives"] = Json::array();
    for (int k = 1; k < position.order(); ++k) {
      Json entry = object_of(2);
      entry["at"] = point(origin(position, k));
      entry["angle"] = number(position.angle[static_cast<std::size_t>(k)]);
      result["derivatives"].push_back(std::move(entry));
    }
    const auto pole = find_pole(position);
    result["pole"] = pole ? point(*pole) : Json(nullptr);
    // Of the path of the point `at`, by the parameter.
    const PathCurvature curvature = find_path_curvature(position, {0.0, 0.0});
    result["path_curvature"] = Json::array(
        {per_length(curvature.k), per_length(curvature.k_prime), per_length(curvature.k_second)});
    const auto frame = find_special_frame(position);
    result["special_frame"] = frame ? frame_json(*frame) : Json(nullptr);
    return result;
  }

  Json frame_json(const SpecialFrame& frame) const {
    Json result = object_of(8);
    result["diameter"] = length(frame.diameter);
    result["angle"] = angle(frame.angle);
    result["derivatives"] = Json::array();
    for (const Point& jet : frame.derivatives) {
      result["derivatives"].push_back(point(jet));
    }
    result["inflection_circle"] = circle_json(inflection_circle(frame));
    result["cuspidal_circle"] = circle_json(cuspidal_circle(frame));
    const auto cubic = find_stationary_curvature(frame);
    result["inverse_m"] = per_length(cubic ? std::optional(cubic->inverse_m) : std::nullopt);
    result["inverse_n"] = per_length(cubic ? std::optional(cubic->inverse_n) : std::nullopt);
    const auto ball = find_ball_point(frame);
    result["ball_point"] = ball ? point(*ball) : Json(nullptr);
    return result;
  }

  Json circle_json(const Circle& circle) const {
    Json result = object_of(2);
    result["centre"] = point(circle.centre);
    result["radius"] = length(circle.radius);
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
      result["dyads"].push_back(dyad_json(dyad));
    }
  }

  static Json reason(Degeneracy why) {
    return why == Degeneracy::none ? Json(nullptr) : Json(word_of(why));
  }

  Json dyad_json(const Dyad& dyad) const {
    const bool is_crank = dyad.kind == DyadKind::crank;
    Json result = object_of(8);
    result["type"] = word_of(dyad.kind);
    result["circle_point"] = point(dyad.circle_point);
    result["centre_point"] = point(dyad.centre_point);
    result["direction"] = is_crank ? Json(nullptr) : direction(dyad.direction);
    result["length"] = is_crank ? length(dyad.length) : Json(nullptr);
    result["multiplicity"] = dyad.multiplicity;
    result["digits"] = number(dyad.digits);
    result["residual"] = number(dyad.residual);
    return result;
  }

  Json linkage_json(const LinkageCandidate& candidate) const {
    Json result = object_of(12);
    result["type"] = word_of(candidate.linkage.type());
    result["dyads"] = Json::array({candidate.dyads[0], candidate.dyads[1]});
    result["defect"] =
        candidate.defect == Defect::none ? Json(nullptr) : Json(word_of(candidate.defect));
    result["drive"] = candidate.best_drive == Drive::one ? 0 : 1;
    result["margin"] = candidate.best().working_arc ? angle(candidate.margin()) : Json(nullptr);
    result["longest"] = length(candidate.longest);
    result["link_ratio"] = number(candidate.ratio);
    result["lengths"] = candidate.lengths ? lengths_json(*candidate.lengths) : Json(nullptr);
    result["grashof"] = Json(nullptr);
    if (candidate.grashof) {
      result["grashof"] = object_of(2);
      result["grashof"]["class"] = word_of(candidate.grashof->kind);
      result["grashof"]["link"] = word_of(candidate.grashof->which);
    }
    result["cognates"] = candidate.cognates ? cognates_json(*candidate.cognates) : Json(nullptr);
    result["drives"] = Json::array();
    for (const DriveVerdict& verdict : candidate.verdicts) {
      result["drives"].push_back(verdict_json(verdict, candidate));
    }
    return result;
  }

  Json lengths_json(const FourBarLengths& lengths) const {
    Json result = object_of(4);
    result["ground"] = length(lengths.ground);
    result["crank_one"] = length(lengths.crank_one);
    result["coupler"] = length(lengths.coupler);
    result["crank_other"] = length(lengths.crank_other);
    return result;
  }

  Json cognates_json(const Cognates& cognates) const {
    Json result = Json::array();
    for (const FourBarPlaces& one : cognates.linkages) {
      Json entry = object_of(3);
      entry["fixed"] = Json::array({point(one.fixed[0]), point(one.fixed[1])});
      entry["moving"] = Json::array({point(one.moving[0]), point(one.moving[1])});
      entry["lengths"] = lengths_json(one.lengths);
      result.push_back(std::move(entry));
    }
    return result;
  }

  Json verdict_json(const DriveVerdict& verdict, const LinkageCandidate& candidate) const {
    const bool is_angle = input_of(candidate.linkage, verdict.drive).kind != DyadKind::slider;
    const auto coordinate = [&](double x) { return is_angle ? angle(x) : length(x); };
    Json result = object_of(12);
    result["coordinates"] = Json::array();
    result["transmission"] = Json::array();
    for (std::size_t i = 0; i < verdict.coordinates.size(); ++i) {
      result["coordinates"].push_back(coordinate(verdict.coordinates[i]));
      result["transmission"].push_back(angle(verdict.transmission[i]));
    }
    result["circuits"] = verdict.circuits;
    result["branches"] = verdict.branches;
    result["same_circuit"] = verdict.same_circuit;
    result["same_branch"] = verdict.same_circuit && verdict.same_branch;
    result["passage"] = word_of(verdict.passage);
    result["turns_fully"] = verdict.turns_fully;
    result["arc"] = verdict.passage == Passage::none ? Json(nullptr) : coordinate(verdict.arc);
    result["working_transmission"] =
        verdict.working_arc ? range_json(*verdict.working_arc) : Json(nullptr);
    result["full_transmission"] = range_json(verdict.full);
    return result;
  }

  Json range_json(const TransmissionRange& range) const {
    return Json::array({angle(range.least), angle(range.most)});
  }

  Json curves_json(const FourPositionCurves& curves, const SynthesisTask& task) const {
    Json result = object_of(8);
    result["status"] = word_of(curves.status);
    result["reason"] = reason(curves.reason);
    result["digits"] = number(curves.digits);
    result["flatness"] = number(curves.flatness);
    const bool is_solved = curves.status == BurmesterStatus::solved;
    result["circle_points"] = is_solved ? cubic_json(curves.circle_points, task) : Json(nullptr);
    result["centre_points"] = is_solved ? cubic_json(curves.centre_points, task) : Json(nullptr);
    result["slider"] = curves.slider ? dyad_json(*curves.slider) : Json(nullptr);
    result["inverted_slider"] =
        curves.inverted_slider ? dyad_json(*curves.inverted_slider) : Json(nullptr);
    return result;
  }

  // Coefficients in the fixed frame, in the file's unit of length.
  Json cubic_json(const PlaneCubic& cubic, const SynthesisTask& task) const {
    const PlaneCubic fixed = cubic.about({0.0, 0.0}, in_.units().factor(QuantityKind::length));
    Json result = object_of(8);
    Json coefficients = object_of(8);
    coefficients["k1"] = number(fixed.k[0]);
    coefficients["k2"] = number(fixed.k[1]);
    coefficients["q11"] = number(fixed.q[0]);
    coefficients["q12"] = number(fixed.q[1]);
    coefficients["q22"] = number(fixed.q[2]);
    coefficients["l1"] = number(fixed.l[0]);
    coefficients["l2"] = number(fixed.l[1]);
    coefficients["c"] = number(fixed.c);
    result["coefficients"] = std::move(coefficients);
    const auto focus = cubic.focus();
    result["focus"] = focus ? point(*focus) : Json(nullptr);
    const auto asymptote = cubic.asymptote();
    result["asymptote"] = Json(nullptr);
    if (asymptote) {
      result["asymptote"] = object_of(2);
      result["asymptote"]["normal"] = direction(asymptote->normal);
      result["asymptote"]["offset"] = length(asymptote->offset);
    }
    result["branches"] = Json::array();
    for (const CurveBranch& branch :
         sample(cubic, middle_of(task), reach_of(task), analysis_.curve_count)) {
      result["branches"].push_back(branch_json(branch));
    }
    return result;
  }

  Json branch_json(const CurveBranch& branch) const {
    Json result = object_of(2);
    result["closed"] = branch.is_closed;
    result["points"] = Json::array();
    for (const Point& one : branch.points) {
      result["points"].push_back(point(one));
    }
    return result;
  }

  static Point middle_of(const SynthesisTask& task) {
    Point sum(0.0, 0.0);
    for (const PositionJets& position : task.positions) {
      sum += origin(position);
    }
    return sum / static_cast<double>(task.positions.size());
  }

  // Curves are drawn within some sizes of the task: the spread of its positions and poles.
  static double reach_of(const SynthesisTask& task) {
    constexpr double kSizes = 4.0;
    double size = 0.0;
    for (const PositionJets& position : task.positions) {
      size = std::max(size, std::abs(origin(position) - middle_of(task)));
      if (const auto pole = find_pole(position)) {
        size = std::max(size, std::abs(*pole - middle_of(task)));
      }
    }
    return size > 0.0 ? kSizes * size : kSizes;
  }

  const SynthesisAnalysis& analysis_;
  InUnits in_;
  double zero_ = 0.0;  // below it a length of the task is rounding [m]
};

}  // namespace

Json synthesis_json(const SynthesisAnalysis& analysis) {
  return SynthesisJson(analysis).run();
}

}  // namespace kinestat
