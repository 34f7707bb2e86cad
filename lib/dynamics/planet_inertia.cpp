#include "dynamics/planet_inertia.hpp"

#include <algorithm>
#include <vector>

#include "core/index.hpp"
#include "core/tolerance.hpp"
#include "mechanism/gears/hinge_lines.hpp"
#include "mechanism/gears/planet_load.hpp"

namespace kinestat {

namespace {

bool joins(const CouplingTopology& coupling, BodyId body) {
  return coupling.tail == body || coupling.head == body;
}

BodyId other_end(const CouplingTopology& coupling, BodyId body) {
  return coupling.tail == body ? coupling.head : coupling.tail;
}

bool has(const HingeLine& line, BodyId body) {
  return std::ranges::binary_search(line.bodies, body.value, {}, &BodyId::value);
}

// Both by no more than they may be off.
bool turns_over(const Vec3& angular, double bound, const Vec3& axis) {
  return angular.cross(axis).norm() > bound + kCancellation * angular.norm();
}

}  // namespace

std::optional<PlanetAxis> axis_of_planets(const Mechanism& mechanism, BodyId planet) {
  const Topology& topology = mechanism.topology;
  std::optional<BodyId> carrier;
  std::vector<BodyId> partners;
  for (const CouplingTopology& one : topology.couplings) {
    if (!joins(one, planet)) {
      continue;
    }
    if (!is_hinge(one.type)) {
      partners.push_back(other_end(one, planet));
    } else if (!carrier && planets_of(mechanism, one) > 1) {
      carrier = other_end(one, planet);
    }
  }
  if (!carrier) {
    return std::nullopt;
  }
  std::vector<HingeLine> lines = find_hinge_lines(topology, mechanism.geometry);
  std::erase_if(lines, [&](const HingeLine& line) {
    return !has(line, *carrier) || std::ranges::any_of(line.hinges, [&](CouplingId hinge) {
      return planets_of(mechanism, topology.coupling(hinge)) > 1;
    });
  });
  if (lines.size() > 1) {  // those of other planets
    std::erase_if(lines, [&](const HingeLine& line) {
      return std::ranges::none_of(partners, [&](BodyId body) { return has(line, body); });
    });
  }
  if (lines.size() != 1) {
    return std::nullopt;
  }
  return PlanetAxis{
      .carrier = *carrier, .direction = lines.front().direction, .point = lines.front().point};
}

std::optional<BoundedWrench> spread_planets(const BoundedWrench& drawn,
                                            const PlanetAxis& axis,
                                            const BodyInertia& planets,
                                            const InertialMotion& motion) {
  const std::size_t c = at(axis.carrier.value);
  const Twist& twist = motion.twists[c];
  const Twist& rate = motion.twist_rates[c];
  const BodyBounds& bounds = motion.bounds[c];
  const Vec3& z = axis.direction;
  if (turns_over(twist.angular, bounds.angular, z) ||
      turns_over(rate.angular, bounds.angular_rate, z)) {
    return std::nullopt;
  }
  // What the planets would do if the axis did not speed up, and that.
  const BodyInertia on_axis{.mass = planets.mass, .centre = axis.point, .tensor = Mat3::Zero()};
  const BoundedWrench carried = inertial_wrench(on_axis, twist, rate, bounds);
  const Vec3 arm = planets.centre - axis.point;
  const BoundedVector about_axis = moment_at(drawn, axis.point);
  const double turns = z.dot(about_axis.value - arm.cross(carried.force.value));
  const double turns_bound =
      about_axis.bound.maxCoeff() + arm.norm() * carried.force.bound.maxCoeff();
  const Vec3 across = carried.force.value - z * z.dot(carried.force.value);
  const Vec3 force = across + z * z.dot(drawn.force.value);
  const Vec3 force_bound = carried.force.bound + z.cwiseAbs() * drawn.force.bound.maxCoeff();
  // At the centre of all, which is on the axis.
  const Vec3 centre = axis.point + z * z.dot(arm);
  const Vec3 moment = turns * z + centre.cross(force);
  const Vec3 moment_bound =
      turns_bound * z.cwiseAbs() +
      Vec3::Constant(centre.norm() * (force_bound.norm() + 4.0 * kEpsilon * force.norm()));
  return BoundedWrench{.moment = {.value = moment, .bound = moment_bound},
                       .force = {.value = force, .bound = force_bound}};
}

}  // namespace kinestat
