#include "dynamics/spring_force.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/index.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

struct Ends {
  Vec3 from;
  Vec3 to;
};

Ends ends_of(const Spring& spring, const LoadState& place) {
  if (place.poses.empty()) {
    return {.from = spring.from, .to = spring.to};
  }
  return {.from = place.poses[at(spring.tail.value)].point(spring.from),
          .to = place.poses[at(spring.head.value)].point(spring.to)};
}

SpringNumbersOf<double> numbers_of(const Spring& spring, double force) {
  SpringNumbersOf<double> numbers{.from = spring.from,
                                  .to = spring.to,
                                  .stiffness = spring.stiffness,
                                  .damping = spring.damping,
                                  .free = spring.free,
                                  .force = force};
  if (spring.gas) {
    numbers.gas = {.force = spring.gas->force,
                   .length = spring.gas->length,
                   .stroke = spring.gas->stroke,
                   .hold = spring.gas->hold,
                   .exponent = spring.gas->exponent};
  }
  return numbers;
}

SpringState state_of_freedom(const Spring& spring, const LoadState& place, double force) {
  const auto value = [&](const std::vector<std::optional<double>>& list) {
    return list.empty() ? 0.0 : list[at(spring.freedom)].value_or(0.0);
  };
  const double position = value(place.positions);
  const double rate = value(place.rates);
  return {.position = position,
          .rate = rate,
          .force = action_of(numbers_of(spring, force), position, rate)};
}

// Whether its force asks for a speed that nobody knows.
bool lacks_speed(const Spring& spring, const LoadState& place) {
  if (spring.damping == 0.0 || place.rates.empty()) {
    return false;
  }
  return spring.is_of_freedom() ? !place.rates[at(spring.freedom)] : place.twists.empty();
}

bool is_past_stroke(const GasSpring& gas, double length) {
  const double pushed_in = gas.length - length;
  return pushed_in < -kPastStroke * gas.stroke || pushed_in > (1.0 + kPastStroke) * gas.stroke;
}

// Whether it pulls with nothing where its points meet, so that it needs no direction there: one
// that has no force without length, and no damping or ends that rest on each other.
bool is_idle_without_length(const Spring& spring, double force, const Vec3& speed) {
  return !spring.gas && force == 0.0 && spring.stiffness * spring.free == 0.0 &&
         (spring.damping == 0.0 || speed.isZero(0.0));
}

// Of what a spring does to a body.
std::string load_name(const Spring& spring, BodyId body, const Topology& topology) {
  const bool is_alone = spring.tail.value == 0 || spring.head.value == 0;
  const std::string name = std::string(kSpringPrefix) + spring.name;
  return is_alone ? name : name + "." + topology.body(body).name;
}

}  // namespace

std::variant<std::vector<SpringState>, SpringObstacle> spring_states(
    const Mechanism& drawn, const LoadState& place, std::span<const double> forces) {
  std::vector<SpringState> states;
  for (std::size_t i = 0; i < drawn.springs.size(); ++i) {
    const Spring& spring = drawn.springs[i];
    if (lacks_speed(spring, place)) {
      return SpringObstacle{.kind = SpringObstacle::Kind::no_speed, .spring = i};
    }
    if (spring.is_of_freedom()) {
      if (!place.positions.empty() && !place.positions[at(spring.freedom)]) {
        return SpringObstacle{.kind = SpringObstacle::Kind::no_position, .spring = i};
      }
      states.push_back(state_of_freedom(spring, place, forces[i]));
      continue;
    }
    const Ends ends = ends_of(spring, place);
    const Vec3 arm = ends.to - ends.from;
    const double length = arm.norm();
    const Vec3 speed = place.twists.empty()
                           ? Vec3(Vec3::Zero())
                           : Vec3(velocity_at(place.twists[at(spring.head.value)], ends.to) -
                                  velocity_at(place.twists[at(spring.tail.value)], ends.from));
    if (!(length > kNoSpringLength * drawn.geometry.length)) {
      if (!is_idle_without_length(spring, forces[i], speed)) {
        return SpringObstacle{.kind = SpringObstacle::Kind::no_length, .spring = i};
      }
      states.push_back({});
      continue;
    }
    SpringState state{.position = length, .rate = speed.dot(arm) / length};
    if (spring.gas && is_past_stroke(*spring.gas, length)) {
      return SpringObstacle{
          .kind = SpringObstacle::Kind::past_stroke, .spring = i, .length = length};
    }
    state.force = tension_of(numbers_of(spring, forces[i]), spring.acts, length, state.rate);
    states.push_back(state);
  }
  return states;
}

PlacedSpring placed_spring(const Spring& spring, const LoadState& place) {
  const bool follows_position = spring.damping == 0.0 && spring.force.law == nullptr;
  PlacedSpring found;
  if (spring.is_of_freedom()) {
    if (place.positions[at(spring.freedom)]) {
      const SpringState state = state_of_freedom(spring, place, spring.force.value);
      found.position = state.position;
      found.force = follows_position ? std::optional(state.force) : std::nullopt;
    }
    return found;
  }
  const Ends ends = ends_of(spring, place);
  const double length = (ends.to - ends.from).norm();
  found.position = length;
  if (follows_position && !(spring.gas && is_past_stroke(*spring.gas, length))) {
    found.force = tension_of(numbers_of(spring, spring.force.value), spring.acts, length, 0.0);
  }
  return found;
}

double stored_energy(const Spring& spring, double position) {
  double stretch = position - spring.free;
  if (!spring.is_of_freedom()) {
    stretch = cut_off(spring.acts, stretch);
  }
  const double of_stiffness = 0.5 * spring.stiffness * stretch * stretch;
  if (!spring.gas) {
    return of_stiffness;
  }
  const GasSpring& gas = *spring.gas;
  if (spring.acts == SpringSense::pull) {
    return of_stiffness;  // gas pushes alone
  }
  if (gas.hold == 0.0) {
    return of_stiffness + gas.force * (gas.length - position);
  }
  const double left = 1.0 - gas.hold * (gas.length - position) / gas.stroke;
  const double scale = gas.force * gas.stroke / gas.hold;
  const double power = 1.0 - gas.exponent;
  return of_stiffness +
         (power == 0.0 ? -scale * std::log(left) : scale * (std::pow(left, power) - 1.0) / -power);
}

double elastic_tension(const Spring& spring, double position) {
  if (spring.is_of_freedom()) {
    return spring.stiffness * (position - spring.free);
  }
  SpringNumbersOf<double> numbers = numbers_of(spring, 0.0);
  if (spring.gas && is_past_stroke(*spring.gas, position)) {
    numbers.gas.reset();
  }
  return tension_of(numbers, spring.acts, position, 0.0);
}

std::vector<Load> spring_loads(const Mechanism& moved,
                               const LoadState& place,
                               const std::vector<SpringState>& states) {
  const Topology& topology = moved.topology;
  std::vector<Load> loads;
  const auto add = [&](const Spring& spring, BodyId body, const Wrench& wrench, auto point) {
    if (body.value == 0) {
      return;
    }
    loads.push_back({.name = load_name(spring, body, topology),
                     .acts = {.body = body, .wrench = wrench},
                     .point = point,
                     .where = spring.where});
  };
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Spring& spring = moved.springs[i];
    if (spring.is_of_freedom()) {
      const FreedomLabel& freedom = topology.freedoms[at(spring.freedom)];
      const Twist& unit = moved.geometry.motions[at(spring.freedom)];
      const Vec3& point = moved.geometry.points[at(freedom.coupling.value)];
      const Wrench on_head =
          freedom.is_rotation
              ? Wrench{.moment = states[i].force * unit.angular, .force = Vec3::Zero()}
              : states[i].force * unit_force<double>(unit.linear, point);
      const std::optional<Vec3> where = freedom.is_rotation ? std::nullopt : std::optional(point);
      add(spring, spring.head, on_head, where);
      add(spring, spring.tail, -1.0 * on_head, where);
      continue;
    }
    const Ends ends = ends_of(spring, place);
    const Vec3 pull = states[i].force * (ends.to - ends.from).normalized();
    add(spring,
        spring.head,
        Wrench{.moment = ends.to.cross(-pull), .force = -pull},
        std::optional<Vec3>(ends.to));
    add(spring,
        spring.tail,
        Wrench{.moment = ends.from.cross(pull), .force = pull},
        std::optional<Vec3>(ends.from));
  }
  return loads;
}

std::vector<std::string> spring_load_names(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const Spring& spring : mechanism.springs) {
    for (const BodyId body : {spring.head, spring.tail}) {
      if (body.value != 0) {
        names.push_back(load_name(spring, body, mechanism.topology));
      }
    }
  }
  return names;
}

}  // namespace kinestat
