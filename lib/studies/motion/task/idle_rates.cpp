#include "studies/motion/task/idle_rates.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

bool has_body(const PassiveFreedom& one, BodyId body) {
  return std::ranges::find(one.bodies, body) != one.bodies.end();
}

// Whether the column of that element is of a freedom, a body or a traced point that it moves.
bool moves_element(const PassiveFreedom& one,
                   const std::string& element,
                   const MotionPlan& plan,
                   const Mechanism& mechanism) {
  const Topology& topology = mechanism.topology;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    if (topology.freedom_name(f) == element) {
      return one.moves(f);
    }
  }
  for (const TracedPoint& point : plan.trace) {
    if (point.name == element) {
      return moves_point(one, point.body, point.at, mechanism);
    }
  }
  const auto at = std::ranges::find(topology.bodies, element, &BodyTopology::name);
  return at != topology.bodies.end() &&
         has_body(one, BodyId{static_cast<int>(at - topology.bodies.begin())});
}

}  // namespace

bool moves_point(const PassiveFreedom& one,
                 BodyId body,
                 const Vec3& drawn,
                 const Mechanism& mechanism) {
  const auto at = std::ranges::find(one.bodies, body);
  if (at == one.bodies.end()) {
    return false;
  }
  const Twist& twist = one.twists[static_cast<std::size_t>(at - one.bodies.begin())];
  const Vec3 velocity = velocity_at(twist, drawn);
  const double fastest =
      std::max(twist.angular.norm() * mechanism.geometry.length, velocity.norm());
  return velocity.norm() > kRankZero * fastest;
}

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
          return moves_element(one, reading.column.element, motion.plan, mechanism);
        });
    if (is_open) {
      reading.is_idle = true;
      reading.value = [](const MotionPosition&) { return std::optional<double>(); };
    }
  }
}

}  // namespace kinestat
