#include "studies/motion/followed_configurations.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "core/contract.hpp"

namespace kinestat {

namespace {

constexpr double kMostKnown = 65'536;

// The share of a motion in which a drive turns by a radian or slides by the mechanism's size, but
// no less than of a motion whose every known place is to be kept.
double far_share(const Mechanism& mechanism, const MotionSolution& motion) {
  double range = 1.0;
  for (const MotionDrive& drive : motion.drives) {
    const bool turns =
        mechanism.topology.freedoms[static_cast<std::size_t>(drive.freedom)].is_rotation;
    range = std::max(range,
                     std::abs(drive.to - drive.from) / (turns ? 1.0 : mechanism.geometry.length));
  }
  return 1.0 / std::min(range, kMostKnown);
}

}  // namespace

FollowedConfigurations::FollowedConfigurations(const Mechanism& mechanism,
                                               const MotionNetwork& network,
                                               const MotionSolution& motion)
    : motion_(motion), way_(network, motion), far_(far_share(mechanism, motion)) {}

std::optional<Configuration> FollowedConfigurations::at(double share) {
  KINESTAT_EXPECTS(motion_.position_count() > 0);
  const std::vector<double>& shares = motion_.shares;
  const auto after = std::ranges::upper_bound(shares, share);
  const auto row = std::max<std::ptrdiff_t>(after - shares.begin() - 1, 0);
  const double begin = shares[static_cast<std::size_t>(row)];
  if (share <= begin || after == shares.end()) {
    return motion_.configuration_at(static_cast<int>(row));
  }
  const auto behind = known_.upper_bound(share);
  const bool is_known = behind != known_.begin() && std::prev(behind)->first > begin;
  const double start = is_known ? std::prev(behind)->first : begin;
  std::optional<Configuration> there =
      is_known ? way_.follow(std::prev(behind)->second, start, share)
               : way_.follow(motion_.configuration_at(static_cast<int>(row)), start, share);
  if (there && share - start > far_) {
    known_.emplace_hint(behind, share, *there);
  }
  return there;
}

}  // namespace kinestat
