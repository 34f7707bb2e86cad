#include "studies/motion/task/idle_rates.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace kinestat {

namespace {

bool is_of_turning(QuantityKind kind) {
  return kind == QuantityKind::angular_velocity || kind == QuantityKind::angular_acceleration;
}

// Whether a rate of that element, a freedom, a traced point or a body, is one that it moves. Of a
// body it is the angular velocity or the velocity of the reference point, or their derivative.
bool moves_element(const PassiveFreedom& one,
                   const std::string& element,
                   QuantityKind kind,
                   const MotionPlan& plan,
                   const Mechanism& mechanism) {
  const Topology& topology = mechanism.topology;
  const double length = mechanism.geometry.length;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    if (topology.freedom_name(f) == element) {
      return one.moves(f);
    }
  }
  for (const TracedPoint& point : plan.trace) {
    if (point.name == element) {
      return one.moves_point(point.body, point.at, length);
    }
  }
  const auto at = std::ranges::find(topology.bodies, element, &BodyTopology::name);
  if (at == topology.bodies.end()) {
    return false;
  }
  const BodyId body{static_cast<int>(at - topology.bodies.begin())};
  const Vec3& reference = mechanism.geometry.references[static_cast<std::size_t>(body.value)];
  return is_of_turning(kind) ? one.turns(body, length) : one.moves_point(body, reference, length);
}

}  // namespace

std::vector<PassiveFreedom> freedoms_of_open_rate(std::vector<PassiveFreedom> passive,
                                                  const MotionPlan& plan,
                                                  const Mechanism& mechanism) {
  if (plan.which < 0) {
    return {};
  }
  std::vector<int> known;
  for (const Primary& one : mechanism.cases[static_cast<std::size_t>(plan.which)].motions) {
    known.push_back(one.index);
  }
  return known.empty() ? std::vector<PassiveFreedom>()
                       : passive_freedoms_beside(std::move(passive), mechanism, known);
}

void leave_out_idle_rates(const FoundMotion& motion,
                          const Mechanism& mechanism,
                          std::vector<MotionReading>& readings) {
  if (motion.network.passive_motions.empty()) {
    return;
  }
  const std::vector<PassiveFreedom> idle = freedoms_of_open_rate(
      find_passive_freedoms(mechanism, spatial_basis(ScrewKind::twist, mechanism.geometry.length)),
      motion.plan,
      mechanism);
  for (MotionReading& reading : readings) {
    const bool is_open =
        (is_rate(reading.kind) || is_rate_of_rate(reading.kind)) &&
        std::ranges::any_of(idle, [&](const PassiveFreedom& one) {
          return moves_element(one, reading.column.element, reading.kind, motion.plan, mechanism);
        });
    if (is_open) {
      reading.is_idle = true;
      reading.value = [](const MotionPosition&) { return std::optional<double>(); };
    }
  }
}

}  // namespace kinestat
