#include "studies/motion/task/figures/approach_limits.hpp"

#include <cmath>
#include <cstddef>

#include "core/motion_tolerance.hpp"
#include "math/numbers/zero_within_bound.hpp"
#include "studies/motion/task/figures/motion_steps.hpp"

namespace kinestat {

void go_to_limits(FigurePlace& place) {
  constexpr double kStraight = 0.01;
  constexpr double kHalves = 0.6;  // of what is left, with half of the way left
  const double uncertain = kSameStep / std::abs(place.step - place.beside);
  for (std::size_t c = 0; c < place.of.values.size(); ++c) {
    std::optional<double>& near = place.of.values[c];
    const std::optional<double>& middle = place.farther[1][c];
    const std::optional<double>& far = place.farther[0][c];
    if (near && middle && far) {
      const double last = *near - *middle;
      const double bend = 2.0 * last - (*middle - *far);
      const double share = last / (*middle - *far);
      const double rest = last * share / (1.0 - share);  // by a power of the way
      if (std::abs(bend) <= kStraight * std::abs(last)) {
        near = zero_within_bound(*near + last + bend / 3.0,
                                 std::abs(bend) + std::abs(last) * uncertain);
      } else if (share > 0.0 && share <= kHalves &&
                 std::abs(last) > kSameApproach * std::abs(*near)) {
        near = zero_within_bound(*near + rest, kStraight * std::abs(rest));
      }
    }
  }
}

std::vector<std::optional<double>> limits_at(const FigurePlace& place) {
  constexpr double kGrows = 0.01;
  std::vector<std::optional<double>> limits = place.of.values;
  for (std::size_t c = 0; c < limits.size() && !place.farther.empty(); ++c) {
    const std::optional<double>& middle = place.farther[1][c];
    const std::optional<double>& far = place.farther[0][c];
    if (!limits[c] || !middle || limits[c] == 0.0) {
      continue;
    }
    const double last = *limits[c] - *middle;
    const bool is_straight = far && std::abs(last - (*middle - *far)) <= kGrows * std::abs(last);
    const bool is_limit = is_straight || std::abs(last) <= kGrows * std::abs(*middle);
    limits[c] = is_limit ? limits[c] : std::nullopt;
  }
  return limits;
}

std::vector<MotionPlace> places_of_lines(std::span<const FigurePlace> places,
                                         std::span<const double> steps) {
  std::vector<MotionPlace> result;
  for (const FigurePlace& place : places) {
    result.push_back({.row = row_at(steps, place.step),
                      .values = place.is_approach ? limits_at(place) : place.of.values});
  }
  return result;
}

}  // namespace kinestat
