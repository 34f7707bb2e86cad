#include "report/plane_cubic_json.hpp"

#include <utility>

#include "synthesis/cubic_branches.hpp"

namespace kinestat {

namespace {

// The largest is 1.
Json coefficients_json(const PlaneCubic& fixed) {
  Json result = object_of(8);
  result["k1"] = number(fixed.k[0]);
  result["k2"] = number(fixed.k[1]);
  result["q11"] = number(fixed.q[0]);
  result["q12"] = number(fixed.q[1]);
  result["q22"] = number(fixed.q[2]);
  result["l1"] = number(fixed.l[0]);
  result["l2"] = number(fixed.l[1]);
  result["c"] = number(fixed.c);
  return result;
}

Json branch_json(const CurveBranch& branch, const PlaneJson& plane) {
  Json result = object_of(2);
  result["closed"] = branch.is_closed;
  result["points"] = Json::array();
  for (const Point& one : branch.points) {
    result["points"].push_back(plane.point(one));
  }
  return result;
}

Json centres_json(const CurveBranch& branch,
                  std::span<const PositionJets> positions,
                  const PlaneJson& plane) {
  Json result = Json::array();
  for (const Point& one : branch.points) {
    const auto dyad = find_dyad(positions, one);
    const bool is_crank = dyad && dyad->kind == DyadKind::crank;
    result.push_back(is_crank ? plane.point(dyad->centre_point) : Json(nullptr));
  }
  return result;
}

}  // namespace

Json cubic_json(const PlaneCubic& cubic,
                const CurveWindow& window,
                const PlaneJson& plane,
                std::span<const PositionJets> positions) {
  const PlaneCubic fixed = cubic.settled_about({0.0, 0.0}, plane.unit_of_length());
  Json result = object_of(8);
  result["coefficients"] = coefficients_json(fixed);
  const auto focus = cubic.focus();
  result["focus"] = focus ? plane.point(*focus) : Json(nullptr);
  const auto asymptote = cubic.asymptote();
  result["asymptote"] = Json(nullptr);
  if (asymptote) {
    result["asymptote"] = object_of(2);
    result["asymptote"]["normal"] = PlaneJson::direction(asymptote->normal);
    result["asymptote"]["offset"] = plane.length(asymptote->offset);
  }
  result["branches"] = Json::array();
  for (const CurveBranch& branch : sample(cubic, window.middle, window.radius, window.count)) {
    result["branches"].push_back(branch_json(branch, plane));
    if (!positions.empty()) {
      result["branches"].back()["centres"] = centres_json(branch, positions, plane);
    }
  }
  return result;
}

}  // namespace kinestat
