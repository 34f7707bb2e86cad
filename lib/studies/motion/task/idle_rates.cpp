#include "studies/motion/task/idle_rates.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace kinestat {

namespace {

// Of a body: where its reference point is, and how that moves.
bool is_of_point(const MotionReading& reading) {
  return reading.kind == QuantityKind::velocity || reading.kind == QuantityKind::acceleration ||
         reading.column.quantity.starts_with("at/");
}

// Whether the column is of a freedom, a body or a traced point that it moves.
bool moves_column(const PassiveFreedom& one,
                  const MotionReading& reading,
                  const MotionPlan& plan,
                  const Mechanism& mechanism) {
  const std::string& element = reading.column.element;
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
  return is_of_point(reading) ? one.moves_point(body, reference, length) : one.turns(body, length);
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

void leave_out_idle_motions(const FoundMotion& motion,
                            const Mechanism& mechanism,
                            std::vector<MotionReading>& readings) {
  if (motion.network.passive_motions.empty()) {
    return;
  }
  const std::vector<PassiveFreedom> all =
      find_passive_freedoms(mechanism, spatial_basis(ScrewKind::twist, mechanism.geometry.length));
  const std::vector<PassiveFreedom> of_rate = freedoms_of_open_rate(all, motion.plan, mechanism);
  for (MotionReading& reading : readings) {
    const auto is_moved_by = [&](const std::vector<PassiveFreedom>& idle) {
      return std::ranges::any_of(idle, [&](const PassiveFreedom& one) {
        return moves_column(one, reading, motion.plan, mechanism);
      });
    };
    const bool is_of_rate = is_rate(reading.kind) || is_rate_of_rate(reading.kind);
    if ((is_of_rate && is_moved_by(of_rate)) || (is_place(reading.column) && is_moved_by(all))) {
      reading.is_idle = true;
      reading.value = [](const MotionPosition&) { return std::optional<double>(); };
    }
  }
}

}  // namespace kinestat
