#include "cases/moving_loads.hpp"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

namespace kinestat {

namespace {

// Springs feel the speeds of the case.
SpringPlace drawn_place(const CaseAnalysis& one) {
  SpringPlace place;
  if (one.motion && one.motion->status == SolveStatus::solved) {
    place.twists = one.motion->bodies;
    place.rates.assign(one.motion->rates.begin(), one.motion->rates.end());
  }
  return place;
}

void add(std::vector<Load> loads, CaseAnalysis& one) {
  std::ranges::move(loads, std::back_inserter(one.which.loads));
}

}  // namespace

void add_spring_loads(const Mechanism& mechanism, const SpringPlace* place, CaseAnalysis& one) {
  const SpringPlace there = place != nullptr ? *place : drawn_place(one);
  auto found = spring_states(mechanism, there);
  if (const auto* obstacle = std::get_if<SpringObstacle>(&found)) {
    one.spring_obstacle = *obstacle;
    return;
  }
  one.springs = std::get<std::vector<SpringState>>(std::move(found));
  add(spring_loads(mechanism, there, one.springs), one);
}

std::optional<InertialMotion> add_inertial_loads(const Mechanism& mechanism,
                                                 const InertialMotion* known,
                                                 CaseAnalysis& one) {
  using Found = std::variant<InertialMotion, InertiaObstacle>;
  Found found =
      known != nullptr ? Found(*known) : find_drawn_motion(mechanism, one.which, *one.motion);
  if (const auto* obstacle = std::get_if<InertiaObstacle>(&found)) {
    one.inertia_obstacle = *obstacle;
    return std::nullopt;
  }
  auto& motion = std::get<InertialMotion>(found);
  add(inertial_loads(mechanism, motion), one);
  return std::move(motion);
}

bool has_typed_loads(const Case& given, const Case& solved) {
  return std::all_of(solved.loads.begin() + static_cast<std::ptrdiff_t>(given.loads.size()),
                     solved.loads.end(),
                     [](const Load& load) { return load.acts.wrench.coordinates().isZero(0.0); });
}

}  // namespace kinestat
