#include "report/linkage_json.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "report/synthesis_report.hpp"
#include "synthesis/linkage_motion.hpp"

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

Json lengths_json(const FourBarLengths& lengths, const PlaneJson& plane) {
  Json result = object_of(4);
  result["ground"] = plane.length(lengths.ground);
  result["crank_one"] = plane.length(lengths.crank_one);
  result["coupler"] = plane.length(lengths.coupler);
  result["crank_other"] = plane.length(lengths.crank_other);
  return result;
}

Json cognates_json(const Cognates& cognates, const PlaneJson& plane) {
  Json result = Json::array();
  for (const FourBarPlaces& one : cognates.linkages) {
    Json entry = object_of(3);
    entry["fixed"] = Json::array({plane.point(one.fixed[0]), plane.point(one.fixed[1])});
    entry["moving"] = Json::array({plane.point(one.moving[0]), plane.point(one.moving[1])});
    entry["lengths"] = lengths_json(one.lengths, plane);
    result.push_back(std::move(entry));
  }
  return result;
}

Json range_json(const TransmissionRange& range, const PlaneJson& plane) {
  return Json::array({plane.angle(range.least), plane.angle(range.most)});
}

Json verdict_json(const DriveVerdict& verdict,
                  const LinkageCandidate& candidate,
                  const PlaneJson& plane) {
  const bool is_angle = input_of(candidate.linkage, verdict.drive).kind != DyadKind::slider;
  const auto coordinate = [&](double x) { return is_angle ? plane.angle(x) : plane.length(x); };
  Json result = object_of(12);
  result["dyad"] = candidate.dyads[verdict.drive == Drive::one ? 0 : 1];
  result["coordinates"] = Json::array();
  result["transmission"] = Json::array();
  for (std::size_t i = 0; i < verdict.coordinates.size(); ++i) {
    result["coordinates"].push_back(coordinate(verdict.coordinates[i]));
    result["transmission"].push_back(plane.angle(verdict.transmission[i]));
  }
  result["circuits"] = verdict.circuits;
  result["branches"] = verdict.branches;
  result["same_circuit"] = verdict.same_circuit;
  result["same_branch"] = verdict.same_circuit && verdict.same_branch;
  result["passage"] = word_of(verdict.passage);
  result["turns_fully"] = verdict.turns_fully;
  result["arc"] = verdict.passage == Passage::none ? Json(nullptr) : coordinate(verdict.arc);
  result["working_transmission"] =
      verdict.working_arc ? range_json(*verdict.working_arc, plane) : Json(nullptr);
  result["full_transmission"] = range_json(verdict.full, plane);
  return result;
}

}  // namespace

Json dyad_json(const Dyad& dyad, const PlaneJson& plane) {
  const bool is_crank = dyad.kind == DyadKind::crank;
  Json result = object_of(10);
  result["type"] = word_of(dyad.kind);
  result["circle_point"] = plane.point(dyad.circle_point);
  result["centre_point"] = plane.point(dyad.centre_point);
  result["direction"] = is_crank ? Json(nullptr) : PlaneJson::direction(dyad.direction);
  result["length"] = is_crank ? plane.length(dyad.length) : Json(nullptr);
  result["multiplicity"] = dyad.multiplicity;
  result["digits"] = number(dyad.digits);
  result["residual"] = number(dyad.residual);
  if (dyad.crank_length > 0.0) {
    result["crank_length"] = plane.length(dyad.crank_length);
    result["deviation"] = plane.length(dyad.deviation);
  }
  return result;
}

Json linkage_json(const LinkageCandidate& candidate, const PlaneJson& plane) {
  Json result = object_of(14);
  result["type"] = word_of(candidate.linkage.type());
  result["dyads"] = Json::array({candidate.dyads[0], candidate.dyads[1]});
  result["defect"] =
      candidate.defect == Defect::none ? Json(nullptr) : Json(word_of(candidate.defect));
  result["drive"] = candidate.dyads[candidate.best_drive == Drive::one ? 0 : 1];
  result["margin"] = candidate.best().working_arc ? plane.angle(candidate.margin()) : Json(nullptr);
  result["longest"] = plane.length(candidate.longest);
  result["link_ratio"] = number(candidate.ratio);
  result["lengths"] = candidate.lengths ? lengths_json(*candidate.lengths, plane) : Json(nullptr);
  result["grashof"] = Json(nullptr);
  if (candidate.grashof) {
    result["grashof"] = object_of(2);
    result["grashof"]["class"] = word_of(candidate.grashof->kind);
    result["grashof"]["link"] = word_of(candidate.grashof->which);
  }
  result["cognates"] =
      candidate.cognates ? cognates_json(*candidate.cognates, plane) : Json(nullptr);
  result["drives"] = Json::array();
  for (const DriveVerdict& verdict : candidate.verdicts) {
    result["drives"].push_back(verdict_json(verdict, candidate, plane));
  }
  return result;
}

Json coupler_curve_json(const LinkageCandidate& candidate,
                        const Pose& start,
                        const CurveExtent& extent,
                        const PlaneJson& plane) {
  const LinkageMotion motion =
      trace_circuit(candidate.linkage, candidate.best_drive, start, extent.count, extent.reach);
  Json result = object_of(2);
  result["closed"] = motion.is_closed;
  result["points"] = Json::array();
  for (const Point& point : coupler_curve(motion, {0.0, 0.0})) {
    result["points"].push_back(plane.point(point));
  }
  return result;
}

}  // namespace kinestat
