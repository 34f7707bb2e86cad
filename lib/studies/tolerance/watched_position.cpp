#include "studies/tolerance/watched_position.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "core/axis_name.hpp"
#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

WatchedPosition freedom_position(const Topology& topology, int freedom) {
  return {.name = topology.freedom_name(freedom),
          .kind = position_kind(topology.freedoms[static_cast<std::size_t>(freedom)].is_rotation),
          .of = freedom};
}

// Where a body can go: all axes in space, two and a turn in the plane.
struct Directions {
  int places = 3;
  int first_turn = 0;
};

Directions directions_of(const Mechanism& mechanism) {
  return mechanism.space == Space::planar ? Directions{.places = 2, .first_turn = 2} : Directions{};
}

void add_place(const Mechanism& mechanism,
               const std::string& name,
               BodyId body,
               const Vec3& at,
               std::vector<WatchedPosition>& list) {
  for (int i = 0; i < directions_of(mechanism).places; ++i) {
    list.push_back({.name = fmt::format("{}/at/{}", name, kAxisNames[static_cast<std::size_t>(i)]),
                    .kind = QuantityKind::length,
                    .of = BodyDisplacement{.body = body, .direction = Vec3::Unit(i), .at = at}});
  }
}

void add_turn(const Mechanism& mechanism,
              const std::string& name,
              BodyId body,
              std::vector<WatchedPosition>& list) {
  for (int i = directions_of(mechanism).first_turn; i < 3; ++i) {
    list.push_back(
        {.name = fmt::format("{}/rotation/{}", name, kAxisNames[static_cast<std::size_t>(i)]),
         .kind = QuantityKind::angle,
         .of = BodyDisplacement{.body = body, .direction = Vec3::Unit(i)}});
  }
}

void add_point(const Mechanism& mechanism,
               const TracedPoint& point,
               std::vector<WatchedPosition>& list) {
  add_place(mechanism, point.name, point.body, point.at, list);
}

// All positions that a name may stand for.
std::vector<WatchedPosition> all_positions(const Mechanism& mechanism,
                                           std::span<const TracedPoint> points) {
  const Topology& topology = mechanism.topology;
  std::vector<WatchedPosition> list;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    list.push_back(freedom_position(topology, f));
  }
  for (const TracedPoint& point : points) {
    add_point(mechanism, point, list);
  }
  for (std::size_t b = 1; b < topology.bodies.size(); ++b) {
    const BodyId body{static_cast<int>(b)};
    const std::string& name = topology.bodies[b].name;
    add_place(mechanism, name, body, mechanism.geometry.references[b], list);
    add_turn(mechanism, name, body, list);
  }
  return list;
}

bool is_held(const Case& which, int freedom) {
  return std::ranges::find(which.motions, freedom, &Primary::index) != which.motions.end();
}

}  // namespace

std::vector<WatchedPosition> watched_positions(const Mechanism& mechanism,
                                               std::span<const TracedPoint> points,
                                               std::string_view name) {
  const Topology& topology = mechanism.topology;
  const auto actuator = std::ranges::find(topology.actuators, name, &ActuatorTopology::name);
  if (actuator != topology.actuators.end()) {
    return {freedom_position(topology, actuator->freedom)};
  }
  std::vector<WatchedPosition> found = all_positions(mechanism, points);
  std::erase_if(found, [&](const WatchedPosition& one) {
    const bool is_component =
        one.name.starts_with(name) && one.name.size() > name.size() && one.name[name.size()] == '/';
    return one.name != name && !is_component;
  });
  return found;
}

std::vector<WatchedPosition> usual_positions(const Mechanism& mechanism,
                                             std::span<const TracedPoint> points,
                                             const Case& which) {
  const Topology& topology = mechanism.topology;
  std::vector<WatchedPosition> list;
  std::vector<int> watched;
  const auto add = [&](int freedom) {
    if (!is_held(which, freedom) && std::ranges::find(watched, freedom) == watched.end()) {
      watched.push_back(freedom);
      list.push_back(freedom_position(topology, freedom));
    }
  };
  std::ranges::for_each(topology.driven_freedoms(), add);
  for (const TracedPoint& point : points) {
    add_point(mechanism, point, list);
  }
  if (list.empty()) {
    for (int f = 0; f < topology.freedom_count(); ++f) {
      add(f);
    }
  }
  return list;
}

std::vector<std::string> watched_names(const Mechanism& mechanism,
                                       std::span<const TracedPoint> points) {
  const Topology& topology = mechanism.topology;
  std::vector<std::string> names;
  std::ranges::transform(topology.actuators, std::back_inserter(names), &ActuatorTopology::name);
  for (int f = 0; f < topology.freedom_count(); ++f) {
    names.push_back(topology.freedom_name(f));
  }
  std::ranges::transform(points, std::back_inserter(names), &TracedPoint::name);
  // A body may have the name of an actuator.
  for (std::size_t b = 1; b < topology.bodies.size(); ++b) {
    if (std::ranges::find(names, topology.bodies[b].name) == names.end()) {
      names.push_back(topology.bodies[b].name);
    }
  }
  return names;
}

}  // namespace kinestat
