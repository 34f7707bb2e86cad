#include "run/internal/motion_events.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/tolerance.hpp"
#include "motion/motion.hpp"
#include "motion/motion_state.hpp"

namespace kinestat {

namespace {

class DeadPointFinder {
 public:
  DeadPointFinder(const Mechanism& mechanism, const FoundMotion& motion)
      : mechanism_(mechanism), motion_(motion), watched_(watched_freedoms()) {
    for (const MotionDrive& drive : motion.solution.drives) {
      per_share_.push_back({.speed = drive.to - drive.from, .acceleration = 0.0});
    }
  }

  std::vector<DeadPoint> run() {
    std::vector<DeadPoint> found;
    if (watched_.empty()) {
      return found;
    }
    std::vector<double> before;
    for (int p = 0; p < motion_.solution.position_count(); ++p) {
      std::vector<double> now = rates_at(motion_.solution.configuration_at(p));
      for (std::size_t i = 0; !before.empty() && !now.empty() && i < watched_.size(); ++i) {
        const auto f = static_cast<std::size_t>(watched_[i]);
        // A rate that is zero at a position itself counts there once.
        if ((before[f] < 0.0 && now[f] >= 0.0) || (before[f] > 0.0 && now[f] <= 0.0)) {
          add(watched_[i], p - 1, found);
        }
      }
      before = std::move(now);
    }
    std::ranges::stable_sort(found, {}, &DeadPoint::share);
    return found;
  }

 private:
  bool is_driven(int freedom) const {
    const auto drives = [&](const MotionDrive& drive) { return drive.freedom == freedom; };
    return std::ranges::any_of(motion_.solution.drives, drives);
  }

  std::vector<int> watched_freedoms() const {
    const Topology& topology = mechanism_.topology;
    const std::vector<int> actuated = topology.driven_freedoms();
    const auto drawn =
        freedom_positions(motion_.network, mechanism_, drawn_configuration(motion_.network));
    std::vector<int> watched;
    for (int f = 0; f < topology.freedom_count(); ++f) {
      const CouplingTopology& coupling =
          topology.coupling(topology.freedoms[static_cast<std::size_t>(f)].coupling);
      const bool is_absolute = coupling.tail.value == 0 || coupling.head.value == 0;
      const bool is_actuated = std::ranges::find(actuated, f) != actuated.end();
      if ((is_absolute || is_actuated) && !is_driven(f) && drawn[static_cast<std::size_t>(f)]) {
        watched.push_back(f);
      }
    }
    return watched;
  }

  // Of all freedoms, per share of the ranges; empty where they are not determined. What is rounding
  // is zero.
  std::vector<double> rates_at(const Configuration& configuration) const {
    const MotionState state =
        solve_state(motion_.network, mechanism_, configuration, per_share_, StateDetail::velocity);
    if (state.is_singular) {
      return {};
    }
    const double length = mechanism_.geometry.length;
    std::vector<double> rates;
    double fastest = 0.0;
    for (std::size_t f = 0; f < state.rates.size(); ++f) {
      const bool turns = mechanism_.topology.freedoms[f].is_rotation;
      rates.push_back(state.rates[f].value_or(0.0));
      fastest = std::max(fastest, std::abs(rates.back()) / (turns ? 1.0 : length));
    }
    for (const int freedom : watched_) {
      const auto f = static_cast<std::size_t>(freedom);
      const bool turns = mechanism_.topology.freedoms[f].is_rotation;
      if (std::abs(rates[f]) <= kNoReaction * fastest * (turns ? 1.0 : length)) {
        rates[f] = 0.0;
      }
    }
    return rates;
  }

  double rate(const Configuration& configuration, std::size_t freedom) const {
    const MotionState state =
        solve_state(motion_.network, mechanism_, configuration, per_share_, StateDetail::velocity);
    return state.is_singular ? 0.0 : state.rates[freedom].value_or(0.0);
  }

  // A place on the way, and how fast the freedom runs there.
  struct Place {
    double share = 0.0;
    Configuration configuration;
    double rate = 0.0;
  };

  Place place_of(int position, std::size_t freedom) const {
    Place place{.share = motion_.solution.shares[static_cast<std::size_t>(position)],
                .configuration = motion_.solution.configuration_at(position)};
    place.rate = rate(place.configuration, freedom);
    return place;
  }

  // Where to look next: at the zero of the line through the ends, a little beyond it, so that the
  // bracket shrinks from both sides; every third time in the middle.
  static double next_share(const Place& low, const Place& high, int round) {
    const double width = high.share - low.share;
    if (round % 3 == 2) {
      return low.share + width / 2.0;
    }
    const double zero = low.share - low.rate * width / (high.rate - low.rate);
    const double edge = std::min(kSameValue / 4.0, width / 4.0);
    const bool is_near_low = std::abs(low.rate) < std::abs(high.rate);
    return std::clamp(is_near_low ? zero + edge : zero - edge, low.share + edge, high.share - edge);
  }

  // From a place to a share of the ranges, in steps so small that the branch is kept.
  std::optional<Configuration> walk(const Place& from, double share) const {
    constexpr double kStep = 0.05;  // [rad, or sizes of the mechanism]
    double reach = 0.0;
    for (const MotionDrive& drive : motion_.solution.drives) {
      const bool turns =
          mechanism_.topology.freedoms[static_cast<std::size_t>(drive.freedom)].is_rotation;
      const double unit = turns ? 1.0 : mechanism_.geometry.length;
      reach = std::max(reach, std::abs(drive.to - drive.from) / unit);
    }
    const double way = share - from.share;
    const int steps = 1 + static_cast<int>(std::abs(way) * reach / kStep);
    std::optional<Configuration> now = from.configuration;
    for (int k = 1; now && k <= steps; ++k) {
      now = configuration_between(
          motion_.network, motion_.solution, *now, from.share + way * k / steps);
    }
    return now;
  }

  void add(int freedom, int step, std::vector<DeadPoint>& found) const {
    const auto f = static_cast<std::size_t>(freedom);
    Place low = place_of(step, f);
    Place high = place_of(step + 1, f);
    for (int round = 0; high.share - low.share > kSameValue; ++round) {
      if (low.rate == 0.0 || high.rate == 0.0) {
        (low.rate == 0.0 ? high : low) = low.rate == 0.0 ? low : high;
        break;
      }
      const double share = next_share(low, high, round);
      std::optional<Configuration> between = walk(low, share);
      if (!between) {
        break;  // The bracket that was reached is what is known.
      }
      Place middle{.share = share, .configuration = *std::move(between)};
      middle.rate = rate(middle.configuration, f);
      (std::signbit(middle.rate) == std::signbit(low.rate) ? low : high) = std::move(middle);
    }
    found.push_back({.freedom = freedom,
                     .step = step,
                     .share = (low.share + high.share) / 2.0,
                     .uncertainty = (high.share - low.share) / 2.0});
  }

  const Mechanism& mechanism_;
  const FoundMotion& motion_;
  std::vector<int> watched_;
  std::vector<DriveSpeed> per_share_;
};

}  // namespace

std::vector<DeadPoint> find_dead_points(const Mechanism& mechanism, const FoundMotion& motion) {
  return DeadPointFinder(mechanism, motion).run();
}

}  // namespace kinestat
