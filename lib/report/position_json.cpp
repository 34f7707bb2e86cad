#include "report/position_json.hpp"

#include <optional>
#include <utility>

#include "synthesis/path_curvature.hpp"

namespace kinestat {

namespace {

Json derivatives_json(const PositionJets& position, const PlaneJson& plane) {
  Json result = Json::array();
  for (int k = 1; k < position.order(); ++k) {
    Json entry = object_of(2);
    entry["at"] = plane.point(origin(position, k));
    entry["angle"] = number(position.angle[static_cast<std::size_t>(k)]);
    result.push_back(std::move(entry));
  }
  return result;
}

// Of a path, by the parameter.
Json curvature_json(const PathCurvature& curvature, const PlaneJson& plane) {
  Json result = Json::array();
  for (const std::optional<double>& value : {curvature.k, curvature.k_prime, curvature.k_second}) {
    result.push_back(plane.per_length(value));
  }
  return result;
}

Json frame_json(const SpecialFrame& frame, const PlaneJson& plane) {
  Json result = object_of(8);
  result["diameter"] = plane.length(frame.diameter);
  result["angle"] = plane.angle(frame.angle);
  result["derivatives"] = Json::array();
  for (const Point& jet : frame.derivatives) {
    result["derivatives"].push_back(plane.point(jet));
  }
  result["inflection_circle"] = plane.circle(inflection_circle(frame));
  result["cuspidal_circle"] = plane.circle(cuspidal_circle(frame));
  const auto cubic = find_stationary_curvature(frame);
  result["inverse_m"] = plane.per_length(cubic ? std::optional(cubic->inverse_m) : std::nullopt);
  result["inverse_n"] = plane.per_length(cubic ? std::optional(cubic->inverse_n) : std::nullopt);
  const auto ball = find_ball_point(frame);
  result["ball_point"] = ball ? plane.point(*ball) : Json(nullptr);
  return result;
}

}  // namespace

Json position_json(const PositionJets& position, const PlaneJson& plane) {
  Json result = object_of(6);
  result["at"] = plane.point(origin(position));
  result["angle"] = plane.angle(position.angle[0]);
  result["derivatives"] = derivatives_json(position, plane);
  const auto pole = find_pole(position);
  result["pole"] = pole ? plane.point(*pole) : Json(nullptr);
  result["path_curvature"] = curvature_json(find_path_curvature(position, {0.0, 0.0}), plane);
  const auto frame = find_special_frame(position);
  result["special_frame"] = frame ? frame_json(*frame, plane) : Json(nullptr);
  return result;
}

}  // namespace kinestat
