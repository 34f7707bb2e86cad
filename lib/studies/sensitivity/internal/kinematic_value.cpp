#include "mechanism/label_kind.hpp"
#include "studies/sensitivity/internal/value_path.hpp"

namespace kinestat {

std::optional<ReportedValue> find_kinematic_value(const DualCase& values, const PathParts& parts) {
  using enum QuantityKind;
  const Topology& topology = values.topology();
  if (parts.size() == 3 && parts[1] == "freedoms") {
    const auto f = index_where(
        topology.freedoms.size(), parts[2], [&](int i) { return topology.freedom_name(i); });
    return f && values.motion()->knows_rate(static_cast<int>(*f))
               ? as_value(kind_of(topology.freedoms[*f]), values.rate(*f))
               : std::nullopt;
  }
  const auto b = parts[1] == "bodies" && parts.size() == 5 ? index_of(topology.bodies, parts[2])
                                                           : std::nullopt;
  if (!b) {
    return std::nullopt;
  }
  const BodyId body{static_cast<int>(*b)};
  const Geometry& geometry = values.mechanism().geometry;
  const bool is_known = parts[3] == "angular"  ? values.motion()->knows_turn(body, geometry.length)
                        : parts[3] == "linear" ? values.motion()->knows_velocity(
                                                     body, geometry.references[*b], geometry.length)
                                               : values.motion()->knows_body(body);
  if (!is_known) {
    return std::nullopt;
  }
  const LocalOrigin& origin = geometry.origin;
  const TwistOf<Dual> twist = values.body_twist(*b);
  const Vec3Of<Dual> at = values.reference(*b);
  if (parts[3] == "twist") {
    const TwistOf<Dual> world = about_world(twist, origin);
    return component(parts, {{angular_velocity, world.angular}, {velocity, world.linear}});
  }
  if (parts[3] == "angular") {
    return component(parts, {{angular_velocity, twist.angular}});
  }
  if (parts[3] == "linear") {
    return component(parts, {{velocity, velocity_at(twist, at)}});
  }
  return parts[3] == "at" ? component(parts, {{length, origin.in_world<Dual>(at)}}) : std::nullopt;
}

}  // namespace kinestat
