#include "studies/motion/task/figures/friction_rests.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "core/motion_tolerance.hpp"
#include "math/dense/root_search.hpp"
#include "studies/motion/task/figures/motion_steps.hpp"

namespace kinestat {

std::optional<FrictionRest> FrictionRests::between(std::size_t friction,
                                                   const PlacesAround& about) {
  const auto [at, is_new] = known_.try_emplace(std::pair(friction, about.before));
  if (is_new) {
    at->second = find(friction, about);
  }
  return at->second;
}

std::optional<FrictionRest> FrictionRests::of(const FrictionTurn& turn, const PlacesAround& about) {
  return about.before == about.after
             ? std::optional(FrictionRest{.begin = about.before, .end = about.before})
             : between(turn.friction, about);
}

std::optional<FrictionRest> FrictionRests::find(std::size_t friction, const PlacesAround& about) {
  const Vec3 first = sliding_at(friction, about.before).value_or(Vec3::Zero());
  const auto stands_at = [&](double step) {
    const std::optional<Vec3> there = sliding_at(friction, step);
    return there && there->norm() <= kSameStep * first.norm();
  };
  std::optional<FrictionRest> rest;
  for (const double time :
       motion_.plan.schedule ? motion_.plan.schedule->turns() : std::vector<double>()) {
    const double step = nearest_row(time * motion_.plan.steps);
    if (about.before < step && step < about.after && stands_at(step)) {
      const bool dwells = rest && stands_at(std::midpoint(rest->end, step));
      rest = {.begin = dwells ? rest->begin : step, .end = step};
    }
  }
  const auto behind = std::ranges::upper_bound(places_, about.before, {}, &FrictionPlace::step);
  const auto end = std::ranges::lower_bound(places_, about.after, {}, &FrictionPlace::step);
  if (rest || end - behind > 1) {
    return rest;
  }
  const double step =
      end - behind == 1 ? behind->step : nearest_row(find_turn(friction, first, about));
  return FrictionRest{.begin = step, .end = step};
}

std::optional<Vec3> FrictionRests::sliding_at(std::size_t friction, double step) const {
  const std::optional<MotionPosition> position = position_at_(step);
  return position && has_motion(*position)
             ? std::optional(sliding_of(mechanism_.topology,
                                        mechanism_.frictions[friction].coupling,
                                        position->state.rates))
             : std::nullopt;
}

double FrictionRests::find_turn(std::size_t friction,
                                const Vec3& first,
                                const PlacesAround& about) const {
  const auto along = [&](double step) {
    const std::optional<Vec3> sliding = sliding_at(friction, step);
    return sliding ? sliding->dot(first) : std::numeric_limits<double>::quiet_NaN();
  };
  return root_between(along, about.before, about.after);
}

}  // namespace kinestat
