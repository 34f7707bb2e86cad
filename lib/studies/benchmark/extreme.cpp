#include "studies/benchmark/extreme.hpp"

#include <string>

#include <fmt/format.h>

namespace kinestat {

namespace {

// The coupler and the rocker lie on one line but for `distance`: where the crank drives, the rocker
// moves 1 / distance times as fast.
SourceFile near_dead_point(const char* distance) {
  return {.path = fmt::format("<dead-point-{}>", distance),
          .text = fmt::format(R"(kinestat: 1
name: Four-bar at {0} from a dead point
space: planar
ground: frame
bodies: [crank, coupler, rocker]
couplings:
  a: {{type: revolute, bodies: [frame, crank], at: [0, 0]}}
  b: {{type: revolute, bodies: [crank, coupler], at: [0.3, 1]}}
  c: {{type: revolute, bodies: [coupler, rocker], at: [2.3, 1 + {0}]}}
  d: {{type: revolute, bodies: [frame, rocker], at: [4.1, 1]}}
actuators:
  motor: {{coupling: a}}
  load: {{coupling: d}}
cases:
  driven: {{motion: {{motor: 1 rad/s}}, action: {{load: 1 N*m}}}}
)",
                              distance)};
}

constexpr int kStages = 80;

// Gear i has a wheel of radius 3.5 that meshes with the pinion, of radius 1, of the gear before.
SourceFile long_train() {
  std::string bodies;
  std::string couplings;
  for (int i = 0; i <= kStages; ++i) {
    bodies += fmt::format("{}g{}", i == 0 ? "" : ", ", i);
    couplings += fmt::format(
        "  p{0}: {{type: revolute, bodies: [frame, g{0}], at: [{1}, 0]}}\n", i, 4.5 * i);
    if (i > 0) {
      couplings += fmt::format(
          "  m{0}: {{type: gear, bodies: [g{1}, g{0}], at: [{2}, 0], line_of_action: [0.3, 1]}}\n",
          i,
          i - 1,
          4.5 * (i - 1) + 1.0);
    }
  }
  return {.path = "<long-train>",
          .text = fmt::format("kinestat: 1\nname: Train of {0} stages of ratio 3.5\nspace: planar\n"
                              "ground: frame\nbodies: [{1}]\ncouplings:\n{2}"
                              "actuators:\n  first: {{coupling: p0}}\n  last: {{coupling: p{0}}}\n"
                              "cases:\n  driven: {{motion: {{first: 1 rad/s}}, "
                              "action: {{first: 1 N*m}}}}\n",
                              kStages,
                              bodies,
                              couplings)};
}

}  // namespace

std::vector<SourceFile> extreme_networks() {
  return {near_dead_point("1e-4"), near_dead_point("1e-8"), long_train()};
}

}  // namespace kinestat
