#include "run/internal/motion_events.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"
#include "motion/motion.hpp"
#include "motion/motion_state.hpp"

namespace kinestat {

namespace {

// A freedom may turn back twice in a long step: rates are looked at this often [rad, or sizes of
// the mechanism], and nearer and nearer to a limit, where the drive stands still.
constexpr double kLongestStretch = 0.1;
constexpr int kStretchesToLimit = 13;
constexpr double kTowardsLimit = 0.25;

class DeadPointFinder {
 public:
  DeadPointFinder(const Mechanism& mechanism, const FoundMotion& motion)
      : mechanism_(mechanism), motion_(motion), watched_(watched_freedoms()) {
    for (const MotionDrive& drive : motion.solution.drives) {
      const bool turns =
          mechanism_.topology.freedoms[static_cast<std::size_t>(drive.freedom)].is_rotation;
      const double way = drive.to - drive.from;
      per_share_.drives.push_back({.speed = way, .acceleration = 0.0});
      reach_ = std::max(reach_, std::abs(way) / (turns ? 1.0 : mechanism_.geometry.length));
    }
  }

  std::vector<DeadPoint> run() {
    if (watched_.empty()) {
      return {};
    }
    std::optional<Place> before;
    for (int p = 0; p < motion_.solution.position_count(); ++p) {
      for (const double share : shares_until(p)) {
        before = before ? go_on(*before, share, p - 1) : std::nullopt;
      }
      before = pass(before, place_at(p), p - 1);
    }
    std::ranges::stable_sort(found_, {}, &DeadPoint::share);
    return std::move(found_);
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

  // A place on the way, and how fast the freedoms run there, per share of the ranges.
  struct Place {
    double share = 0.0;
    Configuration configuration;
    std::vector<double> rates;
    double fastest = 0.0;  // of the rates [rad, or sizes of the mechanism]
  };

  // Between the position before and this one.
  std::vector<double> shares_until(int position) const {
    if (position == 0) {
      return {};
    }
    const std::vector<double>& all = motion_.solution.shares;
    const double from = all[static_cast<std::size_t>(position - 1)];
    const double way = all[static_cast<std::size_t>(position)] - from;
    const int count = static_cast<int>(std::ceil(way * reach_ / kLongestStretch));
    std::vector<double> shares;
    for (int k = 1; k < count; ++k) {
      shares.push_back(from + way * k / count);
    }
    const bool is_limit = motion_.solution.status == MotionStatus::limit &&
                          position + 1 == motion_.solution.position_count();
    double left = shares.empty() ? way : from + way - shares.back();
    for (int k = 0; is_limit && k < kStretchesToLimit; ++k) {
      left *= kTowardsLimit;
      shares.push_back(from + way - left);
    }
    return shares;
  }

  // Empty where the rates are not determined.
  std::optional<Place> place(double share, Configuration configuration) const {
    const MotionState state =
        solve_state(motion_.network, mechanism_, configuration, per_share_, StateDetail::velocity);
    if (state.is_singular) {
      return std::nullopt;
    }
    Place result{.share = share, .configuration = std::move(configuration), .rates = {}};
    for (std::size_t f = 0; f < state.rates.size(); ++f) {
      result.rates.push_back(state.rates[f].value_or(0.0));
      result.fastest = std::max(result.fastest, std::abs(result.rates.back()) / unit_of(f));
    }
    return result;
  }

  // -1, 0 or 1; what is rounding is zero.
  int sense(const Place& place, std::size_t freedom) const {
    const double rate = place.rates[freedom];
    const bool rests = std::abs(rate) <= kNoReaction * place.fastest * unit_of(freedom);
    return rests ? 0 : rate < 0.0 ? -1 : 1;
  }

  double unit_of(std::size_t freedom) const {
    return mechanism_.topology.freedoms[freedom].is_rotation ? 1.0 : mechanism_.geometry.length;
  }

  std::optional<Place> place_at(int position) const {
    return place(motion_.solution.shares[static_cast<std::size_t>(position)],
                 motion_.solution.configuration_at(position));
  }

  std::optional<Place> place_after(const Place& from, double share) const {
    std::optional<Configuration> there = configuration_between(
        motion_.network, motion_.solution, from.configuration, from.share, share);
    return there ? place(share, *std::move(there)) : std::nullopt;
  }

  std::optional<Place> go_on(const Place& from, double share, int step) {
    return pass(from, place_after(from, share), step);
  }

  std::optional<Place> pass(const std::optional<Place>& from, std::optional<Place> to, int step) {
    for (const int freedom : watched_) {
      const auto f = static_cast<std::size_t>(freedom);
      // A rate that is zero at a place itself counts there once.
      if (from && to && sense(*from, f) != 0 && sense(*to, f) != sense(*from, f)) {
        add(freedom, step, *from, *to);
      }
    }
    return to;
  }

  // Where to look next: at the zero of the line through the ends, a little beyond it, so that the
  // bracket shrinks from both sides; every third time in the middle.
  double next_share(const Place& low, const Place& high, std::size_t freedom, int round) const {
    const double width = high.share - low.share;
    if (round % 3 == 2) {
      return low.share + width / 2.0;
    }
    const double low_rate = low.rates[freedom];
    const double high_rate = high.rates[freedom];
    const double zero = low.share - low_rate * width / (high_rate - low_rate);
    const double edge = std::min(kDeadPointBracket / reach_ / 4.0, width / 4.0);
    const bool is_near_low = std::abs(low_rate) < std::abs(high_rate);
    return std::clamp(is_near_low ? zero + edge : zero - edge, low.share + edge, high.share - edge);
  }

  void add(int freedom, int step, Place low, Place high) {
    const auto f = static_cast<std::size_t>(freedom);
    const bool is_low_negative = std::signbit(low.rates[f]);
    if (std::signbit(high.rates[f]) == is_low_negative) {
      low = high;  // It rests there to rounding.
    }
    for (int round = 0; (high.share - low.share) * reach_ > kDeadPointBracket; ++round) {
      const double share = next_share(low, high, f, round);
      std::optional<Place> middle = place_after(low, share);
      if (!middle || share <= low.share || share >= high.share) {
        break;  // The bracket that was reached is what is known.
      }
      (std::signbit(middle->rates[f]) == is_low_negative ? low : high) = *std::move(middle);
    }
    found_.push_back({.freedom = freedom,
                      .step = step,
                      .share = (low.share + high.share) / 2.0,
                      .uncertainty = (high.share - low.share) / 2.0});
  }

  const Mechanism& mechanism_;
  const FoundMotion& motion_;
  std::vector<int> watched_;
  GivenSpeeds per_share_;
  double reach_ = 0.0;  ///< of the fastest drive [rad, or sizes of the mechanism]
  std::vector<DeadPoint> found_;
};

}  // namespace

std::vector<DeadPoint> find_dead_points(const Mechanism& mechanism, const FoundMotion& motion) {
  return DeadPointFinder(mechanism, motion).run();
}

}  // namespace kinestat
