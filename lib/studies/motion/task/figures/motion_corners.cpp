#include "studies/motion/task/figures/motion_corners.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "core/motion_tolerance.hpp"
#include "math/dense/root_search.hpp"
#include "math/numbers/zero_within_bound.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kMostCorners = 10000;

class CornerFinder {
 public:
  CornerFinder(const Mechanism& mechanism,
               const FoundMotion& motion,
               const MotionDetail& detail,
               const SpecialSteps& special,
               const ValuesAt& values_at,
               FollowedConfigurations& configurations)
      : mechanism_(mechanism),
        motion_(motion),
        special_(special),
        values_at_(values_at),
        seeking_(mechanism, motion.plan, motion.network, motion.drawn, seeking_detail(mechanism)),
        reading_(mechanism, motion.plan, motion.network, motion.drawn, detail),
        configurations_(configurations) {}

  Corners find() {
    const int count = motion_.solution.position_count();
    for (const Curve& curve : mechanism_.curves) {
      std::optional<double> before = count > 0 ? argument(curve, 0.0) : std::nullopt;
      for (int row = 0; row + 1 < count; ++row) {
        const std::optional<double> behind = argument(curve, row + 1.0);
        if (before && behind) {
          add_corners(curve, row, *before, *behind);
        }
        if (steps_.size() > kMostCorners) {
          return {};
        }
        before = behind;
      }
    }
    for (std::size_t i = 0; i < mechanism_.springs.size(); ++i) {
      add_contacts(i);
    }
    add_flank_changes();
    Corners found;
    for (const double step : steps_) {
      add_place(step, found.places);
    }
    add_breaks(found.places);
    for (const double step : special_steps()) {
      add_approaches(step, found.places);
      steps_.push_back(step);
    }
    for (const FrictionTurn& turn : special_.turns) {
      for (const RowsAround& rows : turn.turns) {
        add_reversal(turn, rows, found);
      }
    }
    std::ranges::stable_sort(found.places, {}, &FigurePlace::step);
    std::ranges::sort(steps_);
    found.steps = std::move(steps_);
    return found;
  }

 private:
  // Speeds are only looked at where a curve is over one.
  static MotionDetail seeking_detail(const Mechanism& mechanism) {
    MotionDetail detail;
    detail.velocity =
        !mechanism.frictions.empty() || std::ranges::any_of(mechanism.curves, [](const Curve& one) {
          return one.over == Curve::Over::speed;
        });
    return detail;
  }

  // Empty where the motion cannot be followed to there.
  std::optional<MotionPosition> position_at(double step,
                                            MotionPositions& positions,
                                            std::optional<double> at = {}) {
    const double share = share_at_step(motion_, step);
    const std::optional<Configuration> there = configurations_.at(share);
    const std::optional<double> time = motion_.plan.schedule
                                           ? std::optional(at.value_or(step / motion_.plan.steps))
                                           : std::nullopt;
    return there ? std::optional(positions.at(*there, share, time)) : std::nullopt;
  }

  std::optional<double> argument(const Curve& curve, double step) {
    const std::optional<MotionPosition> position = position_at(step, seeking_);
    if (!position) {
      return std::nullopt;
    }
    switch (curve.over) {
      case Curve::Over::time:
        return position->time;
      case Curve::Over::position:
        return position->freedoms[static_cast<std::size_t>(curve.freedom)];
      case Curve::Over::speed:
        return has_motion(*position)
                   ? position->state.rates[static_cast<std::size_t>(curve.freedom)]
                   : std::nullopt;
    }
    return std::nullopt;
  }

  // At its points between the two arguments.
  void add_corners(const Curve& curve, int row, double before, double behind) {
    const auto [low, high] = std::minmax(before, behind);
    const double first = curve.period ? std::floor((low - curve.at.front()) / *curve.period) : 0.0;
    for (double turn = first; turn == first || curve.period; ++turn) {
      const double shift = curve.period ? turn * *curve.period : 0.0;
      if (curve.at.front() + shift >= high || steps_.size() > kMostCorners) {
        break;
      }
      for (const double point : curve.at) {
        if (low < point + shift && point + shift < high) {
          steps_.push_back(step_at(curve, row, point + shift));
        }
      }
    }
  }

  // Of a spring that acts one way alone; a damper begins and ends with a jump.
  void add_contacts(std::size_t spring) {
    const auto acts_in = [&](const std::vector<SpringState>& springs) -> std::optional<bool> {
      return spring < springs.size() ? std::optional(springs[spring].force != 0.0) : std::nullopt;
    };
    const bool is_one_sided = mechanism_.springs[spring].acts != SpringSense::both;
    for (std::size_t row = 0; is_one_sided && row + 1 < special_.springs.size(); ++row) {
      const std::optional<bool> here = acts_in(special_.springs[row]);
      const std::optional<bool> next = acts_in(special_.springs[row + 1]);
      if (!here || !next || *here == *next) {
        continue;
      }
      const auto acts_as_here = [&](double step) {
        const std::optional<MotionPosition> position = position_at(step, reading_);
        return position && position->solved && acts_in(position->solved->springs) == here ? 1.0
                                                                                          : -1.0;
      };
      const auto begin = static_cast<double>(row);
      const double step = root_between(acts_as_here, begin, begin + 1.0);
      (mechanism_.springs[spring].damping == 0.0 ? steps_ : jumps_).push_back(step);
    }
  }

  void add_flank_changes() {
    for (std::size_t row = 0; row + 1 < special_.coast_flanks.size(); ++row) {
      const std::vector<int>& here = special_.coast_flanks[row];
      std::vector<int> changed;
      std::ranges::set_symmetric_difference(
          here, special_.coast_flanks[row + 1], std::back_inserter(changed));
      for (const int flank : changed) {
        const auto is_among = [&](const std::vector<int>& coast) {
          return std::ranges::find(coast, flank) != coast.end();
        };
        const auto presses_as_here = [&](double step) {
          const std::optional<MotionPosition> position = position_at(step, reading_);
          return position && position->solved &&
                         is_among(position->solved->coast_flanks) == is_among(here)
                     ? 1.0
                     : -1.0;
        };
        const auto begin = static_cast<double>(row);
        steps_.push_back(root_between(presses_as_here, begin, begin + 1.0));
      }
    }
  }

  double step_at(const Curve& curve, int row, double wanted) {
    return root_between(
        [&](double step) {
          const std::optional<double> found = argument(curve, step);
          return found ? *found - wanted : std::numeric_limits<double>::quiet_NaN();
        },
        row,
        row + 1.0);
  }

  void add_place(double step, std::vector<FigurePlace>& corners) {
    if (const auto position = position_at(step, reading_)) {
      const double share = share_at_step(motion_, step);
      corners.push_back({.step = step, .share = share, .of = values_at_(*position, share)});
    }
  }

  // Where a law changes its acceleration there are two values, that before and that behind, at one
  // place.
  void add_breaks(std::vector<FigurePlace>& corners) {
    if (!motion_.plan.schedule) {
      return;
    }
    for (const double time : motion_.plan.schedule->breaks()) {
      const double step = time * motion_.plan.steps;
      if (step >= motion_.solution.position_count() - 1.0 || corners.size() > kMostCorners) {
        return;
      }
      steps_.push_back(step);
      const double before = DriveSchedule::before(time);
      if (const auto position = position_at(step, reading_, before)) {
        corners.push_back({.step = before * motion_.plan.steps,
                           .share = motion_.plan.schedule->share_at(before),
                           .of = values_at_(*position, share_at_step(motion_, step))});
      }
      if (step != std::floor(step)) {
        add_place(step, corners);
      }
    }
  }

  double last_step() const { return step_of_row(motion_, motion_.solution.shares.size() - 1); }

  // Each once, in order; what falls on a row but for rounding is at the row.
  std::vector<double> special_steps() {
    std::vector<double> all(special_.poles.begin(), special_.poles.end());
    all.insert(all.end(), jumps_.begin(), jumps_.end());
    bool jumps = false;
    for (std::size_t f = 0; f < mechanism_.frictions.size(); ++f) {
      if (!vanishes_at_rest(mechanism_.frictions[f])) {
        add_friction_turns(f, all);
        jumps = true;
      }
    }
    for (const FrictionTurn& turn : special_.turns) {
      for (const RowsAround& rows : turn.turns) {
        if (const std::optional<double> step = step_of(turn, rows)) {
          all.push_back(*step);
        }
      }
    }
    if (motion_.plan.schedule && jumps) {
      all.push_back(0.0);
      all.push_back(last_step());
      for (const double time : motion_.plan.schedule->turns()) {
        all.push_back(std::min(time * motion_.plan.steps, last_step()));
      }
    }
    for (double& step : all) {
      step = std::abs(step - std::round(step)) < kSameStep ? std::round(step) : step;
    }
    std::ranges::sort(all);
    const auto is_same = [](double a, double b) { return b - a < kSameStep; };
    all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
    return all;
  }

  // Of two rows between which it slides one way and then the other, or of a row that it rests in.
  void add_friction_turns(std::size_t friction, std::vector<double>& steps) {
    const auto sliding = [&](std::size_t row) {
      const std::vector<Vec3>& rates = special_.sliding[row].rates;
      return rates.empty() ? Vec3(Vec3::Zero()) : rates[friction];
    };
    for (std::size_t row = 0; row + 1 < special_.sliding.size(); ++row) {
      const Vec3 here = sliding(row);
      const Vec3 next = sliding(row + 1);
      if (here.isZero(0.0) != next.isZero(0.0)) {
        steps.push_back(static_cast<double>(here.isZero(0.0) ? row : row + 1));
      } else if (here.dot(next) < 0.0) {
        steps.push_back(turn_between(friction, here, static_cast<double>(row)));
      }
    }
  }

  // Sought once for the places beside it and for its event.
  double turn_between(std::size_t friction, const Vec3& before, double row) {
    const auto [at, is_new] = turns_.try_emplace(std::pair(friction, row));
    if (is_new) {
      at->second = find_turn(friction, before, row);
    }
    return at->second;
  }

  double find_turn(std::size_t friction, const Vec3& before, double row) {
    return root_between(
        [&](double step) {
          const std::optional<MotionPosition> position = position_at(step, seeking_);
          const CouplingId id = mechanism_.frictions[friction].coupling;
          return position && has_motion(*position)
                     ? sliding_of(mechanism_.topology, id, position->state.rates).dot(before)
                     : std::numeric_limits<double>::quiet_NaN();
        },
        row,
        row + 1.0);
  }

  // A longer rest has no place.
  std::optional<double> step_of(const FrictionTurn& turn, const RowsAround& rows) {
    const auto before = static_cast<double>(rows.before);
    switch (rows.after - rows.before) {
      case 0:
        return step_of_row(motion_, rows.before);
      case 1: {
        const double step =
            turn_between(turn.friction, special_.sliding[rows.before].rates[turn.friction], before);
        return std::abs(step - std::round(step)) < kSameStep ? std::round(step) : step;
      }
      case 2:
        return before + 1.0;
      default:
        return std::nullopt;
    }
  }

  // Without what grows towards it: what runs straight there comes nearer by as much each time.
  static std::vector<std::optional<double>> limits_at(const FigurePlace& place) {
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

  void add_reversal(const FrictionTurn& turn, const RowsAround& rows, Corners& found) {
    const std::optional<double> step = step_of(turn, rows);
    if (!step) {
      return;
    }
    FrictionReversal reversal{.coupling = turn.coupling, .step = *step};
    for (const FigurePlace& place : found.places) {
      if (place.is_approach && std::abs(place.beside - *step) < kSameStep) {
        (place.step < place.beside ? reversal.before : reversal.after) = limits_at(place);
      }
    }
    found.reversals.push_back(std::move(reversal));
  }

  void add_approaches(double step, std::vector<FigurePlace>& corners) {
    if (step > 0.0 && step <= last_step()) {
      add_approach(std::ceil(step) - 1.0, step, corners);
    }
    if (step >= 0.0 && step < last_step()) {
      add_approach(std::min(std::floor(step) + 1.0, last_step()), step, corners);
    }
  }

  bool is_pole(double step) const {
    return std::ranges::any_of(special_.poles,
                               [&](double pole) { return std::abs(pole - step) < kSameStep; });
  }

  // As near as there are values. Beside a place where a drive turns back or stops it moves too
  // slowly for friction to have a direction, and they are what those farther from it come to.
  void add_approach(double row, double step, std::vector<FigurePlace>& corners) {
    FigurePlace place{.of = {}, .is_approach = true, .beside = step};
    for (const double way : {kApproach, 0x1p6 * kApproach, 0x1p12 * kApproach}) {
      place.farther.clear();
      bool rests = false;
      for (const double left : {4.0 * way, 2.0 * way, way}) {
        place.step = std::lerp(step, row, left);
        place.share = share_at_step(motion_, place.step);
        const std::optional<MotionPosition> position = position_at(place.step, reading_);
        if (!position) {
          return;
        }
        place.of = values_at_(*position, place.share);
        rests = position->without_friction.has_value();
        if (left > way) {
          place.farther.push_back(place.of.values);
        }
      }
      if (!rests) {
        break;
      }
    }
    go_to_limits(place);
    place.step = std::lerp(step, row, kApproach);
    place.share = share_at_step(motion_, place.step);
    if (!is_pole(step)) {
      place.farther.clear();
    }
    corners.push_back(std::move(place));
  }

  // Of values that run straight towards the place, by the parabola through the three; what that
  // adds to the line bounds the error, and so does how well the place is known.
  static void go_to_limits(FigurePlace& place) {
    constexpr double kStraight = 0.01;
    constexpr double kHalves = 0.6;  // of what is left, with half of the way left
    const bool is_far = std::abs(place.step - place.beside) > kSameApproach;
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
        } else if (is_far && share > 0.0 && share <= kHalves) {
          near = zero_within_bound(*near + rest, kStraight * std::abs(rest));
        }
      }
    }
  }

  const Mechanism& mechanism_;
  const FoundMotion& motion_;
  const SpecialSteps& special_;
  const ValuesAt& values_at_;
  MotionPositions seeking_;
  MotionPositions reading_;
  FollowedConfigurations& configurations_;
  std::vector<double> steps_;
  std::vector<double> jumps_;                               // of springs
  std::map<std::pair<std::size_t, double>, double> turns_;  // steps, by friction and row before
};

}  // namespace

double step_of_row(const FoundMotion& motion, std::size_t row) {
  const bool is_last = row + 1 == motion.solution.shares.size();
  return motion.plan.schedule && is_last
             ? motion.plan.schedule->time_at(motion.solution.shares[row]) * motion.plan.steps
             : static_cast<double>(row);
}

double share_at_step(const FoundMotion& motion, double step) {
  if (motion.plan.schedule) {
    return motion.plan.schedule->share_at(step / motion.plan.steps);
  }
  const std::vector<double>& shares = motion.solution.shares;
  const auto row = static_cast<std::size_t>(step);
  return row + 1 < shares.size() ? std::lerp(shares[row], shares[row + 1], step - std::floor(step))
                                 : shares.back();
}

double step_at_share(const FoundMotion& motion, double share) {
  if (motion.plan.schedule) {
    return motion.plan.schedule->time_at(share) * motion.plan.steps;
  }
  const std::vector<double>& shares = motion.solution.shares;
  const auto behind = std::ranges::upper_bound(shares, share);
  if (behind == shares.begin() || behind == shares.end()) {
    return behind == shares.begin() ? 0.0 : static_cast<double>(shares.size() - 1);
  }
  const double before = *std::prev(behind);
  return static_cast<double>(behind - shares.begin() - 1) + (share - before) / (*behind - before);
}

Corners find_corners(const Mechanism& mechanism,
                     const FoundMotion& motion,
                     const MotionDetail& detail,
                     const SpecialSteps& special,
                     const ValuesAt& values_at,
                     FollowedConfigurations& configurations) {
  const bool has_any = !mechanism.curves.empty() || motion.plan.schedule ||
                       !mechanism.frictions.empty() || !mechanism.springs.empty() ||
                       !mechanism.geometry.other_flanks.empty() || !special.poles.empty();
  return has_any
             ? CornerFinder(mechanism, motion, detail, special, values_at, configurations).find()
             : Corners{};
}

void add_reversals(const FoundMotion& motion,
                   std::span<const FrictionReversal> reversals,
                   const std::function<std::vector<double>(double share)>& drives_at,
                   MotionTable& table) {
  for (const FrictionReversal& one : reversals) {
    const double beside = one.step > kSameStep ? one.step - kSameStep : one.step + kSameStep;
    std::vector<double> drive = drives_at(share_at_step(motion, one.step));
    const double apart = drives_at(share_at_step(motion, beside)).front() - drive.front();
    drive.front() = zero_within_bound(drive.front(), std::abs(apart));
    const auto behind = std::ranges::find_if(
        table.events, [&](const MotionEvent& event) { return event.row > one.step; });
    table.events.insert(behind,
                        {.kind = std::string(kFrictionReversalEvent),
                         .element = one.coupling,
                         .step = std::max(static_cast<int>(std::ceil(one.step)) - 1, 0),
                         .drive = drive,
                         .uncertainty = std::abs(apart),
                         .row = one.step,
                         .places = {},
                         .before = one.before,
                         .after = one.after});
  }
}

}  // namespace kinestat
