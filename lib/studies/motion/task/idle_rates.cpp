#include "studies/motion/task/idle_rates.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

bool has_body(const PassiveFreedom& one, BodyId body) {
  return std::ranges::find(one.bodies, body) != one.bodies.end();
}

bool is_of_time(QuantityKind kind) {
  return kind == QuantityKind::angular_velocity || kind == QuantityKind::velocity ||
         kind == QuantityKind::angular_acceleration || kind == QuantityKind::acceleration;
}

// Whether the column of that element is of a freedom, a body or a traced point that it moves.
bool moves_element(const PassiveFreedom& one,
                   const std::string& element,
                   const MotionPlan& plan,
                   const Mechanism& mechanism) {
  const Topology& topology = mechanism.topology;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    if (topology.freedom_name(f) == element) {
      return moves_freedom(one, f);
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

bool moves_freedom(const PassiveFreedom& one, int freedom) {
  return std::abs(one.rates[freedom]) > kRankZero * one.rates.cwiseAbs().maxCoeff();
}

bool moves_point(const PassiveFreedom& one,
                 BodyId body,
                 const Vec3& drawn,
                 const Mechanism& mechanism) {
  const Vec3 velocity = velocity_at(one.twist, drawn);
  const double fastest =
      std::max(one.twist.angular.norm() * mechanism.geometry.length, velocity.norm());
  return has_body(one, body) && velocity.norm() > kRankZero * fastest;
}

bool is_rate_open(const PassiveFreedom& one, const MotionPlan& plan, const Mechanism& mechanism) {
  if (plan.which < 0) {
    return false;
  }
  const std::vector<Primary>& known = mechanism.cases[static_cast<std::size_t>(plan.which)].motions;
  return !known.empty() && std::ranges::none_of(known, [&](const Primary& given) {
    return moves_freedom(one, given.index);
  });
}

void leave_out_idle_rates(const FoundMotion& motion,
                          const Mechanism& mechanism,
                          std::vector<MotionReading>& readings) {
  if (motion.network.passive_motions.empty()) {
    return;
  }
  std::vector<PassiveFreedom> idle =
      find_passive_freedoms(mechanism, spatial_basis(ScrewKind::twist, mechanism.geometry.length));
  std::erase_if(
      idle, [&](const PassiveFreedom& one) { return !is_rate_open(one, motion.plan, mechanism); });
  for (MotionReading& reading : readings) {
    const bool is_open =
        is_of_time(reading.kind) && std::ranges::any_of(idle, [&](const PassiveFreedom& one) {
          return moves_element(one, reading.column.element, motion.plan, mechanism);
        });
    if (is_open) {
      reading.is_idle = true;
      reading.value = [](const MotionPosition&) { return std::optional<double>(); };
    }
  }
}

}  // namespace kinestat
