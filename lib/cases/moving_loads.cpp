#include "cases/moving_loads.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>
#include <vector>

namespace kinestat {

namespace {

// With the speeds of the case.
LoadState drawn_place(const Mechanism& mechanism, const CaseAnalysis& one) {
  LoadState place;
  if (!one.motion) {
    return place;
  }
  place.rates.assign(mechanism.topology.freedoms.size(), std::nullopt);
  if (one.motion->status == SolveStatus::solved) {
    place.twists = one.motion->bodies;
    for (std::size_t f = 0; f < place.rates.size(); ++f) {
      if (one.motion->knows_rate(static_cast<int>(f))) {
        place.rates[f] = one.motion->rates[f];
      }
    }
  }
  return place;
}

void add(std::vector<Load> loads, CaseAnalysis& one) {
  one.which.loads.insert(
      one.which.loads.end(), std::move_iterator(loads.begin()), std::move_iterator(loads.end()));
}

// Those of a mechanism that stands there.
void add_spring_loads(const Mechanism& mechanism,
                      const LoadState& place,
                      const std::vector<double>& forces,
                      CaseAnalysis& one) {
  auto found = spring_states(mechanism, place, forces);
  if (const auto* obstacle = std::get_if<SpringObstacle>(&found)) {
    one.spring_obstacle = *obstacle;
    return;
  }
  one.springs = std::get<std::vector<SpringState>>(std::move(found));
  add(spring_loads(mechanism, place, one.springs), one);
}

}  // namespace

void add_placed_loads(const Mechanism& mechanism, const LoadState* place, CaseAnalysis& one) {
  const LoadState there = place != nullptr ? *place : drawn_place(mechanism, one);
  auto found = curve_numbers(mechanism, one.which, there);
  if (const auto* obstacle = std::get_if<CurveObstacle>(&found)) {
    one.curve_obstacle = *obstacle;
    return;
  }
  auto& numbers = std::get<CurveNumbers>(found);
  for (std::size_t i = 0; i < numbers.actions.size(); ++i) {
    one.which.actions[i].value = numbers.actions[i];
  }
  add(std::move(numbers.loads), one);
  if (!mechanism.springs.empty()) {
    add_spring_loads(mechanism, there, numbers.springs, one);
  }
}

std::optional<InertialMotion> drawn_inertial_motion(const Mechanism& mechanism, CaseAnalysis& one) {
  auto found = find_drawn_motion(mechanism, one.which, *one.motion);
  if (const auto* obstacle = std::get_if<InertiaObstacle>(&found)) {
    one.inertia_obstacle = *obstacle;
    return std::nullopt;
  }
  return std::get<InertialMotion>(std::move(found));
}

void add_inertial_loads(const Mechanism& mechanism,
                        const InertialMotion& motion,
                        CaseAnalysis& one) {
  add(inertial_loads(mechanism, motion), one);
}

bool has_typed_loads(const Case& given, const Case& solved) {
  return std::ranges::none_of(solved.actions, &Primary::moves) &&
         std::all_of(solved.loads.begin() + static_cast<std::ptrdiff_t>(given.loads.size()),
                     solved.loads.end(),
                     [](const Load& load) { return load.acts.wrench.coordinates().isZero(0.0); });
}

}  // namespace kinestat
