#include "mechanism/gears/internal/helix_check.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"

namespace kinestat {

namespace {

// axis x tangent, from the line of action cos(alpha) tangent + sin(alpha) axis x tangent across the
// axis.
Vec3 outwards(const CouplingGeometry& geometry, double alpha) {
  const Vec3& axis = geometry.axis.direction;
  const Vec3& line = geometry.line_of_action;
  return std::cos(alpha) * axis.cross(line) + std::sin(alpha) * (line - line.dot(axis) * axis);
}

// Whether nothing else holds the body but teeth.
bool hangs_on(const HingeLine& line, BodyId body, const Topology& topology) {
  for (int e = 0; e < topology.coupling_count(); ++e) {
    const CouplingTopology& one = topology.coupling(CouplingId{e});
    const bool holds = (one.tail == body || one.head == body) && !has_teeth(one.type);
    if (holds && std::ranges::find(line.hinges, CouplingId{e}) == line.hinges.end()) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool has_helix_by_tangent(const CouplingDescription& coupling) {
  return coupling.helix_angle && coupling.tangent && coupling.pressure_angle;
}

void check_hand(const CouplingDescription& coupling,
                const CouplingGeometry& geometry,
                const Topology& topology,
                BodyId tail,
                std::span<const HingeLine> lines,
                const Evaluator& evaluator,
                Diagnostics& found) {
  const auto is_of_tail = [&](const HingeLine& line) {
    return std::ranges::find(line.bodies, tail) != line.bodies.end();
  };
  const auto line = std::ranges::find_if(lines, is_of_tail);
  if (line == lines.end() || !hangs_on(*line, tail, topology)) {
    return;
  }
  Diagnostics said_before;
  const std::optional<double> beta =
      evaluator.complaining_to(said_before).number(*coupling.helix_angle, QuantityKind::angle);
  const std::optional<double> alpha =
      evaluator.complaining_to(said_before).number(*coupling.pressure_angle, QuantityKind::angle);
  if (!beta || *beta == 0.0 || !alpha) {
    return;
  }
  // Of teeth on a pitch circle, which the tangent touches; about other lines there is no hand.
  const Vec3& axis = geometry.axis.direction;
  const Vec3 radius = axis.cross(geometry.at - line->point).cross(axis);
  const Vec3 normal = outwards(geometry, *alpha);
  const double size = normal.norm() * radius.norm();
  const bool is_radial = normal.cross(radius).norm() <= kSlackInCarrier * size;
  const bool is_about_axis = line->direction.cross(axis).norm() <= kParallelAxes;
  if (!is_about_axis || !is_radial || normal.dot(radius) >= 0.0) {
    return;
  }
  found.error(
      "E0305",
      coupling.tangent->where,
      fmt::format(
          "axis x tangent of coupling '{}' points to the axis of its tail '{}', so that its helix "
          "would be of the other hand",
          coupling.name.text,
          coupling.tail.text),
      "reverse 'tangent': a negative action of the teeth then is the force against it");
}

}  // namespace kinestat
