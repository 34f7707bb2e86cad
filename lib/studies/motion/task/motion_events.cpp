#include "studies/motion/task/motion_events.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"
#include "studies/motion/followed_configurations.hpp"
#include "studies/motion/hermite_cubic.hpp"
#include "studies/motion/motion.hpp"
#include "studies/motion/motion_state.hpp"
#include "studies/motion/path_leg.hpp"
#include "studies/motion/task/reversals.hpp"

namespace kinestat {

namespace {

// Rates are looked at so often that the fastest freedom turns or shifts no farther between two
// looks [rad, or sizes of the mechanism], and nearer and nearer to where they are not determined.
constexpr double kLongestStretch = 0.1;
constexpr double kUsualStretch = 0.8 * kLongestStretch;  // where rates grow meanwhile
constexpr int kStretchesToSingular = 13;
constexpr double kTowardsSingular = 0.25;

// Looks between the positions: more would take longer than anybody waits.
constexpr int kMostLooks = 500'000;

class DeadPointFinder {
 public:
  // Of drives that run along a straight line.
  DeadPointFinder(const Mechanism& mechanism,
                  const MotionNetwork& network,
                  const MotionSolution& solution)
      : mechanism_(mechanism),
        network_(network),
        solution_(solution),
        watched_(watched_freedoms(mechanism, network)),
        states_(network, mechanism),
        way_(network, solution) {
    for (const MotionDrive& drive : solution.drives) {
      const bool turns =
          mechanism_.topology.freedoms[static_cast<std::size_t>(drive.freedom)].is_rotation;
      const double way = drive.to - drive.from;
      per_share_.drives.push_back({.speed = way, .acceleration = 0.0});
      reach_ = std::max(reach_, std::abs(way) / (turns ? 1.0 : mechanism_.geometry.length));
    }
  }

  DeadPoints run() {
    if (watched_.empty()) {
      return {};
    }
    std::optional<Place> before;
    std::optional<double> singular;  // the share of a position behind which nothing is known yet
    for (int p = 0; p < solution_.position_count(); ++p) {
      std::optional<Place> here = place_at(p);
      const double share = solution_.shares[static_cast<std::size_t>(p)];
      if (!here) {
        if (before) {
          before = approach(*std::move(before), share);
        }
        singular = before ? std::nullopt : std::optional(share);
        continue;
      }
      if (singular) {
        leave(*singular, *here);
        singular.reset();
      } else if (before) {
        look(*before, *here);
      }
      before = std::move(here);
    }
    std::ranges::stable_sort(found_, {}, &DeadPoint::share);
    return {.points = std::move(found_), .may_lack_some = may_lack_some_};
  }

 private:
  // A place on the way, and how fast the freedoms run there, per share of the ranges.
  struct Place {
    double share = 0.0;
    Configuration configuration;
    std::vector<double> rates;
    std::vector<double> bends;   // their derivatives; empty where they would be rounding
    std::vector<double> bounds;  // of each rate; empty where all are far above it
    double fastest = 0.0;        // of the rates [rad, or sizes of the mechanism]

    bool rests(std::size_t freedom) const {
      return !bounds.empty() && std::abs(rates[freedom]) <= bounds[freedom];
    }
  };

  // Empty where the rates are not determined.
  std::optional<Place> place(double share, Configuration configuration) {
    const MotionState state = states_.solve(configuration, per_share_, StateDetail::acceleration);
    if (state.is_singular) {
      return std::nullopt;
    }
    Place result{.share = share,
                 .configuration = std::move(configuration),
                 .rates = {},
                 .bends = {},
                 .bounds = {}};
    for (std::size_t f = 0; f < state.rates.size(); ++f) {
      result.rates.push_back(state.rates[f].value_or(0.0));
      result.fastest = std::max(result.fastest, std::abs(result.rates.back()) / unit_of(f));
    }
    for (const std::optional<double>& bend : state.rate_rates) {
      result.bends.push_back(bend.value_or(0.0));
    }
    return result;
  }

  // The same, with the bounds of its rates if one may rest by them.
  std::optional<Place> judged(std::optional<Place> place) {
    if (place && may_rest(*place)) {
      const MotionState state =
          states_.solve_bounded(place->configuration, per_share_, StateDetail::velocity);
      place->bounds = state.bounds.rates;
    }
    return place;
  }

  // Whether a rate is so slow that its bound has to say if it is zero.
  bool may_rest(const Place& place) const {
    return std::ranges::any_of(watched_, [&](int freedom) {
      const auto f = static_cast<std::size_t>(freedom);
      return std::abs(place.rates[f]) <= kDoubtfulRate * place.fastest * unit_of(f);
    });
  }

  // -1, 0 or 1.
  static int sense(const Place& place, std::size_t freedom) {
    return place.rests(freedom) ? 0 : place.rates[freedom] < 0.0 ? -1 : 1;
  }

  double unit_of(std::size_t freedom) const {
    return mechanism_.topology.freedoms[freedom].is_rotation ? 1.0 : mechanism_.geometry.length;
  }

  std::optional<Place> place_at(int position) {
    return judged(place(solution_.shares[static_cast<std::size_t>(position)],
                        solution_.configuration_at(position)));
  }

  std::optional<Place> place_after(const Place& from, double share) {
    std::optional<Configuration> there = way_.follow(from.configuration, from.share, share);
    return there ? place(share, *std::move(there)) : std::nullopt;
  }

  // The last regular place on the way to a singular position.
  Place approach(Place from, double share) {
    double left = share - from.share;
    for (int k = 0; k < kStretchesToSingular; ++k) {
      left *= kTowardsSingular;
      if (std::optional<Place> to = judged(place_after(from, share - left))) {
        look(from, *to);
        from = *std::move(to);
      }
    }
    return from;
  }

  // Backwards, from a regular place to a singular position at which the motion begins.
  void leave(double share, Place to) {
    MotionSolution reversed;
    reversed.drives = solution_.drives;
    for (MotionDrive& drive : reversed.drives) {
      std::swap(drive.from, drive.to);
    }
    WayBetween backwards(network_, reversed);
    double left = to.share - share;
    for (int k = 0; k < kStretchesToSingular; ++k) {
      left *= kTowardsSingular;
      std::optional<Configuration> there =
          backwards.follow(to.configuration, 1.0 - to.share, 1.0 - (share + left));
      std::optional<Place> from =
          there ? judged(place(share + left, *std::move(there))) : std::nullopt;
      if (from) {
        look(*from, to);
        to = *std::move(from);
      }
    }
  }

  // Between two regular places, in stretches within which every rate is a cubic.
  void look(Place from, const Place& to) {
    while (const std::optional<double> part = next_part(from, to)) {
      std::optional<Place> middle = place_between(from, to, *part);
      if (!middle) {
        break;
      }
      look(std::move(from), *middle);
      from = *std::move(middle);
    }
    for (const int freedom : watched_) {
      const auto f = static_cast<std::size_t>(freedom);
      const int before = sense(from, f);
      const int after = sense(to, f);
      // A rate that is zero at a place itself counts there once, where it comes to rest.
      if (before != 0 && after != before) {
        add(freedom, from, to);
      } else if (before == 0 && after != 0 && from.share == solution_.shares.front()) {
        add(freedom, from, from);
      }
    }
  }

  // The part of the way between two places at which to look; none where what happens between them
  // is known, or cannot be.
  std::optional<double> next_part(const Place& from, const Place& to) {
    const double way = to.share - from.share;
    const double stretch = std::max(from.fastest, to.fastest) * way;
    std::optional<double> part;
    if (stretch > kLongestStretch) {
      part = std::min(0.5, kUsualStretch / (from.fastest * way));
    }
    for (std::size_t i = 0; i < watched_.size() && !part && stretch > kLeastLook; ++i) {
      part = doubtful_part(from, to, static_cast<std::size_t>(watched_[i]), stretch);
    }
    if (part && looks_ + stretch / kLongestStretch > kMostLooks) {
      may_lack_some_ = true;
      return std::nullopt;
    }
    return part;
  }

  // At that part of the way or, where nothing is known of it, beside it or in the middle.
  std::optional<Place> place_between(const Place& from, const Place& to, double part) {
    for (const double here : {part, 0.5}) {
      for (const double aside : {0.0, 0.14, -0.14}) {
        const double at = here + aside * std::min(here, 1.0 - here);
        const double share = from.share + at * (to.share - from.share);
        if (share <= from.share || share >= to.share) {
          return std::nullopt;
        }
        ++looks_;
        if (std::optional<Place> found = judged(place_after(from, share))) {
          return found;
        }
      }
    }
    return std::nullopt;
  }

  // The part of a stretch at which a rate may turn back and turn back again.
  std::optional<double> doubtful_part(const Place& from,
                                      const Place& to,
                                      std::size_t freedom,
                                      double stretch) const {
    const int before = sense(from, freedom);
    const int after = sense(to, freedom);
    if (from.bends.empty() || to.bends.empty()) {
      return std::nullopt;
    }
    if (before == 0 && from.bends[freedom] * after < 0.0) {
      return 0.5;  // It sets out in one sense and has the other later.
    }
    if (before != 0 && after == 0 && to.bends[freedom] * before > 0.0) {
      return 0.5;  // It comes to rest from the other sense.
    }
    if (before == 0 || after == 0) {
      return std::nullopt;
    }
    const double way = to.share - from.share;
    const HermiteCubic rate{.low = from.rates[freedom],
                            .high = to.rates[freedom],
                            .low_slope = way * from.bends[freedom],
                            .high_slope = way * to.bends[freedom]};
    return rate.doubtful_part(rate.error(stretch));
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

  // At that share or, where nothing is known of it, at another one between the two.
  std::optional<Place> place_within(const Place& low, const Place& high, double share) {
    for (const double part : {0.0, 0.5, 0.25, 0.75}) {
      const double here = part == 0.0 ? share : low.share + part * (high.share - low.share);
      if (here > low.share && here < high.share) {
        if (std::optional<Place> found = place_after(low, here)) {
          return found;
        }
      }
    }
    return std::nullopt;
  }

  // How far from a place where a rate rests by its bound it may be zero indeed.
  static double share_of_rounding(const Place& place, std::size_t freedom) {
    const bool has_slope = !place.bends.empty() && place.bends[freedom] != 0.0;
    return place.rests(freedom) && has_slope
               ? place.bounds[freedom] / std::abs(place.bends[freedom])
               : 0.0;
  }

  void add(int freedom, Place low, Place high) {
    const auto f = static_cast<std::size_t>(freedom);
    double rounding = 0.0;
    const bool is_low_negative = std::signbit(low.rates[f]);
    if (std::signbit(high.rates[f]) == is_low_negative) {
      low = high;  // It rests there to rounding.
      rounding = share_of_rounding(low, f);
    }
    for (int round = 0; (high.share - low.share) * reach_ > kDeadPointBracket; ++round) {
      std::optional<Place> middle = place_within(low, high, next_share(low, high, f, round));
      if (!middle) {
        break;  // The bracket that was reached is what is known.
      }
      (std::signbit(middle->rates[f]) == is_low_negative ? low : high) = *std::move(middle);
    }
    const double share = (low.share + high.share) / 2.0;
    found_.push_back({.freedom = freedom,
                      .step = last_position_before(share),
                      .share = share,
                      .uncertainty = std::max(rounding, (high.share - low.share) / 2.0),
                      .configuration = std::move(low.configuration)});
  }

  int last_position_before(double share) const {
    const std::vector<double>& all = solution_.shares;
    const auto behind = std::ranges::lower_bound(all, share);
    return std::max(static_cast<int>(behind - all.begin()) - 1, 0);
  }

  const Mechanism& mechanism_;
  const MotionNetwork& network_;
  const MotionSolution& solution_;
  std::vector<int> watched_;
  MotionStates states_;
  WayBetween way_;
  GivenSpeeds per_share_;
  double reach_ = 0.0;  ///< of the fastest drive [rad, or sizes of the mechanism]
  int looks_ = 0;       ///< between the positions
  bool may_lack_some_ = false;
  std::vector<DeadPoint> found_;
};

// Of drives that run by laws of their own: from turn to turn, where they run along a straight line
// between two.
class DeadPointsOnPath {
 public:
  DeadPointsOnPath(const Mechanism& mechanism, const FoundMotion& motion)
      : mechanism_(mechanism),
        motion_(motion),
        solution_(motion.solution),
        configurations_(mechanism, motion.network, motion.solution) {
    for (const MotionDrive& drive : solution_.drives) {
      const bool turns =
          mechanism.topology.freedoms[static_cast<std::size_t>(drive.freedom)].is_rotation;
      units_.push_back(turns ? 1.0 : mechanism.geometry.length);
    }
  }

  DeadPoints run() {
    const double end = solution_.shares.empty() ? 0.0 : solution_.shares.back();
    std::vector<double> ends;
    std::ranges::copy_if(
        solution_.turns, std::back_inserter(ends), [&](double turn) { return turn < end; });
    ends.push_back(end);
    double from = 0.0;
    for (const double to : ends) {
      const PathLeg leg(solution_.path, units_, from, to);
      if (leg.moves() && leg.bow() <= kStraightWay) {
        add(leg);
      }
      found_.may_lack_some = found_.may_lack_some || leg.bow() > kStraightWay;
      from = to;
    }
    return std::move(found_);
  }

 private:
  // The leg as a motion of its own, whose shares are of the line.
  std::optional<MotionSolution> alone(const PathLeg& leg) {
    MotionSolution line;
    line.coordinate_count = solution_.coordinate_count;
    line.angle_count = solution_.angle_count;
    for (std::size_t d = 0; d < units_.size(); ++d) {
      line.drives.push_back({.freedom = solution_.drives[d].freedom,
                             .from = leg.low()[d] * units_[d],
                             .to = leg.high()[d] * units_[d]});
    }
    std::vector<double> shares = {leg.from()};
    std::ranges::copy_if(solution_.shares, std::back_inserter(shares), [&](double share) {
      return share > leg.from() && share < leg.to();
    });
    shares.push_back(leg.to());
    for (const double share : shares) {
      const double of_line = leg.part_at(share);
      const std::optional<Configuration> here = line.shares.empty() || of_line > line.shares.back()
                                                    ? configurations_.at(share)
                                                    : std::nullopt;
      if (here) {
        line.shares.push_back(of_line);
        std::ranges::copy(here->coordinates, std::back_inserter(line.coordinates));
        std::ranges::copy(here->angles, std::back_inserter(line.angles));
      }
    }
    return line.shares.size() > 1 ? std::optional(std::move(line)) : std::nullopt;
  }

  void add(const PathLeg& leg) {
    const std::optional<MotionSolution> line = alone(leg);
    if (!line) {
      found_.may_lack_some = true;
      return;
    }
    DeadPoints on_line = DeadPointFinder(mechanism_, motion_.network, *line).run();
    found_.may_lack_some = found_.may_lack_some || on_line.may_lack_some;
    for (DeadPoint& one : on_line.points) {
      const double low = leg.share(one.share - one.uncertainty);
      const double high = leg.share(one.share + one.uncertainty);
      one.share = leg.share(one.share);
      one.uncertainty = std::max(high - one.share, one.share - low);
      const auto behind = std::ranges::lower_bound(solution_.shares, one.share);
      one.step = std::max(static_cast<int>(behind - solution_.shares.begin()) - 1, 0);
      found_.points.push_back(std::move(one));
    }
  }

  const Mechanism& mechanism_;
  const FoundMotion& motion_;
  const MotionSolution& solution_;
  FollowedConfigurations configurations_;
  std::vector<double> units_;  // of each drive
  DeadPoints found_;
};

}  // namespace

std::vector<int> watched_freedoms(const Mechanism& mechanism, const MotionNetwork& network) {
  const Topology& topology = mechanism.topology;
  const std::vector<int> actuated = topology.driven_freedoms();
  const auto drawn = freedom_positions(network, mechanism, drawn_configuration(network));
  std::vector<int> watched;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    const CouplingTopology& coupling =
        topology.coupling(topology.freedoms[static_cast<std::size_t>(f)].coupling);
    const bool is_absolute = coupling.tail.value == 0 || coupling.head.value == 0;
    const bool is_actuated = std::ranges::find(actuated, f) != actuated.end();
    const bool is_driven =
        std::ranges::find(network.driven_freedoms, f) != network.driven_freedoms.end();
    if ((is_absolute || is_actuated) && !is_driven && drawn[static_cast<std::size_t>(f)]) {
      watched.push_back(f);
    }
  }
  return watched;
}

MotionEnd end_of(MotionStatus status) {
  switch (status) {
    case MotionStatus::completed:
      return MotionEnd::complete;
    case MotionStatus::limit:
    case MotionStatus::lift_off:
      return MotionEnd::limited;
    case MotionStatus::drives_locked:
      return MotionEnd::drives_locked;
    case MotionStatus::not_assembled:
      return MotionEnd::not_assembled;
    case MotionStatus::singular:
    case MotionStatus::lost_branch:
    case MotionStatus::undetermined:
    case MotionStatus::not_movable:
      return MotionEnd::lost;
  }
  return MotionEnd::lost;
}

DeadPoints find_dead_points(const Mechanism& mechanism, const FoundMotion& motion) {
  DeadPoints found = motion.solution.path
                         ? DeadPointsOnPath(mechanism, motion).run()
                         : DeadPointFinder(mechanism, motion.network, motion.solution).run();
  judge_reversals(mechanism, motion, found.points);
  return found;
}

}  // namespace kinestat
