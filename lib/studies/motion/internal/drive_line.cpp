#include "studies/motion/internal/drive_line.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion_tolerance.hpp"

namespace kinestat {

DriveLine DriveLine::between(std::span<const double> from, std::span<const double> to) {
  DriveLine range{.from = {from.begin(), from.end()}, .reach = {}, .scale = 0.0};
  for (std::size_t d = 0; d < from.size(); ++d) {
    range.reach.push_back(to[d] - from[d]);
    range.scale = std::max(range.scale, std::abs(range.reach.back()));
  }
  range.scale = range.scale > 0.0 ? range.scale : 1.0;
  return range;
}

int DriveLine::sense_in(const DriveLine& other) const {
  double along = 0.0;
  double against = 0.0;
  for (std::size_t d = 0; d < reach.size(); ++d) {
    const double here = reach[d] / scale;
    const double there = other.reach[d] / other.scale;
    along = std::max(along, std::abs(here - there));
    against = std::max(against, std::abs(here + there));
  }
  return along <= kSameStep ? 1 : against <= kSameStep ? -1 : 0;
}

double DriveLine::share_of(const DriveLine& other, double share) const {
  const auto fastest =
      std::ranges::max_element(reach, {}, [](double one) { return std::abs(one); });
  const auto d = static_cast<std::size_t>(fastest - reach.begin());
  return reach[d] == 0.0 ? 0.0 : (other.value(d, share) - from[d]) / reach[d];
}

}  // namespace kinestat
