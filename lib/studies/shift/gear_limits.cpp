#include "studies/shift/gear_limits.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "mechanism/gears/mesh.hpp"
#include "power/net_shafts.hpp"

namespace kinestat {

namespace {

constexpr BodyId kGround = {0};

class PartSearch {
 public:
  PartSearch(const Mechanism& mechanism, const ShiftPlan& plan)
      : topology_(mechanism.topology),
        plan_(plan),
        shafts_(topology_, find_meshes(topology_, mechanism.geometry)) {}

  std::vector<LimitedPart> run() {
    for (const ShiftLimit& limit : plan_.limits) {
      const bool is_of_elements = limit.kind == LimitKind::torque || limit.kind == LimitKind::slip;
      const int count =
          is_of_elements ? static_cast<int>(plan_.elements.size()) : topology_.body_count();
      for (int i = 0; i < count; ++i) {
        if (limit.index == i || (limit.index < 0 && is_meant(limit.kind, i))) {
          add(limit, i);
        }
      }
    }
    return std::move(parts_);
  }

 private:
  bool is_planet(int body) const { return shafts_.carrier_of(BodyId{body}).has_value(); }

  // By a limit for all.
  bool is_meant(LimitKind kind, int index) const {
    switch (kind) {
      case LimitKind::torque:
      case LimitKind::slip:
        return true;
      case LimitKind::speed:
        return index != kGround.value && !is_planet(index);
      case LimitKind::planet_speed:
        return is_planet(index);
    }
    return false;
  }

  void add(ShiftLimit limit, int index) {
    if (limit.kind == LimitKind::planet_speed && !is_planet(index)) {
      return;
    }
    limit.index = index;
    parts_.push_back({.limit = limit,
                      .seen_from = limit.kind == LimitKind::planet_speed
                                       ? *shafts_.carrier_of(BodyId{index})
                                       : kGround});
  }

  const Topology& topology_;
  const ShiftPlan& plan_;
  NetShafts shafts_;
  std::vector<LimitedPart> parts_;
};

std::optional<double> size_of(const std::optional<double>& value) {
  return value ? std::optional(std::abs(*value)) : std::nullopt;
}

bool moves(const SolvedGear& gear) {
  return gear.motion != nullptr && gear.motion->status == SolveStatus::solved;
}

std::optional<double> speed_of(const SolvedGear& gear, const LimitedPart& part) {
  if (!moves(gear)) {
    return std::nullopt;
  }
  const BodyId body{part.limit.index};
  if (!gear.motion->knows_body(body) || !gear.motion->knows_body(part.seen_from)) {
    return std::nullopt;
  }
  const std::vector<Twist>& bodies = gear.motion->bodies;
  const Vec3 turning = bodies[static_cast<std::size_t>(body.value)].angular -
                       bodies[static_cast<std::size_t>(part.seen_from.value)].angular;
  return turning.norm();
}

LimitUse speed_use(const SolvedGear& gear,
                   const LimitedPart& part,
                   const std::optional<double>& size) {
  return {.part = part, .size = size, .is_open = !size && moves(gear)};
}

// Losses that lock a gear leave its torques open.
LimitUse torque_use(const SolvedGear& gear, const LimitedPart& part) {
  const auto element = static_cast<std::size_t>(part.limit.index);
  LimitUse use{.part = part, .size = size_of(torque_of(gear, element))};
  if (!gear.mechanism.lossy_meshes.empty()) {
    const std::optional<double> lossy = size_of(lossy_torque_of(gear, element));
    use.has_losses = use.size && lossy && *lossy > *use.size;
    use.size = use.size && lossy ? std::optional(std::max(*use.size, *lossy)) : std::nullopt;
  }
  return use;
}

}  // namespace

std::optional<double> LimitUse::use() const {
  return size ? std::optional(*size / part.limit.most) : std::nullopt;
}

bool LimitUse::is_exceeded() const {
  return size && *size > part.limit.most * (1.0 + kSameValue);
}

std::vector<LimitedPart> find_limited_parts(const Mechanism& mechanism, const ShiftPlan& plan) {
  return plan.limits.empty() ? std::vector<LimitedPart>() : PartSearch(mechanism, plan).run();
}

std::vector<LimitUse> find_limit_uses(const SolvedGear& gear) {
  std::vector<LimitUse> uses;
  for (const LimitedPart& part : find_limited_parts(gear.mechanism, gear.plan)) {
    const auto index = static_cast<std::size_t>(part.limit.index);
    switch (part.limit.kind) {
      case LimitKind::torque:
        uses.push_back(torque_use(gear, part));
        break;
      case LimitKind::slip:
        uses.push_back(speed_use(gear, part, size_of(slip_of(gear, index))));
        break;
      case LimitKind::speed:
      case LimitKind::planet_speed:
        uses.push_back(speed_use(gear, part, speed_of(gear, part)));
        break;
    }
  }
  return uses;
}

const LimitUse* find_largest_use(std::span<const LimitUse> uses) {
  const LimitUse* largest = nullptr;
  for (const LimitUse& one : uses) {
    if (!one.size && !one.is_open) {
      return nullptr;
    }
    if (one.is_open) {
      continue;
    }
    if (largest == nullptr || *one.use() > *largest->use() * (1.0 + kSameValue)) {
      largest = &one;
    }
  }
  return largest;
}

const std::string& owner_of(const LimitedPart& part,
                            const ShiftPlan& plan,
                            const Topology& topology) {
  const auto index = static_cast<std::size_t>(part.limit.index);
  const bool is_of_element =
      part.limit.kind == LimitKind::torque || part.limit.kind == LimitKind::slip;
  return is_of_element
             ? topology.actuators[static_cast<std::size_t>(plan.elements[index].actuator)].name
             : topology.bodies[index].name;
}

std::string name_of(const LimitedPart& part, const ShiftPlan& plan, const Topology& topology) {
  return fmt::format("{}.{}", word_of(part.limit.kind), owner_of(part, plan, topology));
}

}  // namespace kinestat
