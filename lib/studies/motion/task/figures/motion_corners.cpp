#include "studies/motion/task/figures/motion_corners.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "core/motion_tolerance.hpp"
#include "core/tolerance.hpp"
#include "math/dense/root_search.hpp"
#include "studies/motion/task/figures/approach_limits.hpp"
#include "studies/motion/task/figures/friction_rests.hpp"
#include "studies/motion/task/figures/motion_steps.hpp"

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
        configurations_(configurations),
        rests_(mechanism, motion, special.sliding, [this](double step) {
          return position_at(step, seeking_);
        }) {}

  Corners find() {
    const int count = motion_.solution.position_count();
    for (const Curve& curve : mechanism_.curves) {
      std::optional<double> before = count > 0 ? argument(curve, 0.0) : std::nullopt;
      for (int row = 0; row + 1 < count; ++row) {
        const std::optional<double> behind = argument(curve, row + 1.0);
        if (before && is_point(curve, *before)) {
          rows_.push_back(row);
        }
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
    std::ranges::sort(steps_);
    drop_doubles(steps_);
    Corners found;
    for (const double step : steps_) {
      add_place(step, found.places);
    }
    add_law_corners(found.places);
    steps_.insert(steps_.end(), rows_.begin(), rows_.end());
    found.turns = steps_;
    std::ranges::sort(found.turns);
    for (const double step : special_steps()) {
      add_approaches(step, found.places);
      steps_.push_back(step);
    }
    for (const FrictionTurn& turn : special_.turns) {
      for (const PlacesAround& about : turn.turns) {
        add_reversal(turn, about, found);
      }
    }
    for (const FrictionPlace& one : special_.sliding) {
      if (!one.row) {
        add_place(one.step, found.places, {.of = {}, .is_for_peaks = true});
      }
    }
    std::ranges::sort(steps_);
    add_time_pieces(found);
    add_middles(found);
    add_sharp_bends(found.places);
    std::ranges::stable_sort(found.places, {}, &FigurePlace::step);
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

  static bool is_point(const Curve& curve, double argument) {
    const double turns =
        curve.period ? std::floor((argument - curve.at.front()) / *curve.period) : 0.0;
    const double shift = curve.period ? turns * *curve.period : 0.0;
    return std::ranges::any_of(curve.at, [&](double one) { return one + shift == argument; });
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
      if (!special_.coast_flanks[row] || !special_.coast_flanks[row + 1]) {
        continue;
      }
      const std::vector<int>& here = *special_.coast_flanks[row];
      std::vector<int> changed;
      std::ranges::set_symmetric_difference(
          here, *special_.coast_flanks[row + 1], std::back_inserter(changed));
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

  // What is not known of it yet is read there.
  void add_place(double step, std::vector<FigurePlace>& corners, FigurePlace place = {}) {
    if (const auto position = position_at(step, reading_)) {
      place.step = step;
      place.share = share_at_step(motion_, step);
      place.of = values_at_(*position, place.share);
      corners.push_back(std::move(place));
    }
  }

  // Where a law changes its acceleration at once there are two values, that before and that
  // behind, at one place.
  void add_law_corners(std::vector<FigurePlace>& corners) {
    if (!motion_.plan.schedule) {
      return;
    }
    const std::vector<double> breaks = motion_.plan.schedule->breaks();
    for (const double time : motion_.plan.schedule->corners()) {
      const double step = nearest_row(time * motion_.plan.steps);
      if (step >= motion_.solution.position_count() - 1.0 || corners.size() > kMostCorners) {
        return;
      }
      steps_.push_back(step);
      const double before = DriveSchedule::before(time);
      const bool is_break = std::ranges::any_of(
          breaks, [time](double one) { return std::abs(one - time) <= 2.0 * kSameValue; });
      const auto position = is_break ? position_at(step, reading_, before) : std::nullopt;
      if (position) {
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
      for (const PlacesAround& about : turn.turns) {
        if (const std::optional<FrictionRest> rest = rests_.of(turn, about)) {
          all.insert(all.end(), {rest->begin, rest->end});
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
    std::ranges::transform(all, all.begin(), nearest_row);
    std::ranges::sort(all);
    drop_doubles(all);
    return all;
  }

  // In order; those of two curves, or of a period that ends and begins anew.
  static void drop_doubles(std::vector<double>& steps) {
    const auto is_same = [](double a, double b) { return b - a < kSameStep; };
    steps.erase(std::unique(steps.begin(), steps.end(), is_same), steps.end());
  }

  // Of two places between which it slides one way and then the other, or of one that it rests at.
  void add_friction_turns(std::size_t friction, std::vector<double>& steps) {
    for (std::size_t p = 0; p + 1 < special_.sliding.size(); ++p) {
      const FrictionPlace& here = special_.sliding[p];
      const FrictionPlace& next = special_.sliding[p + 1];
      const bool slides = here.sliding.slides(friction);
      if (slides != next.sliding.slides(friction)) {
        steps.push_back(slides ? next.step : here.step);
      } else if (slides && here.sliding.rates[friction].dot(next.sliding.rates[friction]) < 0.0) {
        const FrictionRest rest =
            *rests_.between(friction, {.before = here.step, .after = next.step});
        steps.insert(steps.end(), {rest.begin, rest.end});
      }
    }
  }

  void add_reversal(const FrictionTurn& turn, const PlacesAround& about, Corners& found) {
    const std::optional<FrictionRest> rest = rests_.of(turn, about);
    if (!rest) {
      return;
    }
    FrictionReversal reversal{.coupling = turn.coupling, .step = rest->end};
    for (const FigurePlace& place : found.places) {
      if (!place.is_approach) {
        continue;
      }
      if (place.step < place.beside && std::abs(place.beside - rest->begin) < kSameStep) {
        reversal.before = limits_at(place);
      } else if (place.step > place.beside && std::abs(place.beside - rest->end) < kSameStep) {
        reversal.after = limits_at(place);
      }
    }
    found.reversals.push_back(std::move(reversal));
  }

  // Of the way: laws in time have their own places.
  void add_sharp_bends(std::vector<FigurePlace>& places) {
    if (motion_.plan.schedule) {
      return;
    }
    look_into_sharp_bends(special_.rates, [&](double step) {
      const auto position = position_at(step, reading_);
      const double share = share_at_step(motion_, step);
      if (position) {
        places.push_back({.step = step,
                          .share = share,
                          .of = values_at_(*position, share),
                          .is_for_peaks = true});
      }
      return position ? position->state.rates : FreedomRates();
    });
  }

  void add_time_pieces(Corners& found) {
    if (!motion_.plan.schedule) {
      return;
    }
    found.pieces = find_time_pieces(mechanism_.topology, motion_.plan, last_step(), steps_);
    for (const TimePiece& piece : found.pieces) {
      for (const TimePoint& point : piece.points) {
        add_place(point.step, found.places, {.of = {}, .weight = point.weight});
      }
    }
  }

  // Of what lies between two corners, or one and the end, within a step: else nothing shows what is
  // greatest between them.
  void add_middles(Corners& found) {
    constexpr double kShort = 0.25;  // what corners show themselves
    std::vector<double> ends = steps_;
    ends.push_back(last_step());
    double begin = 0.0;
    for (const double end : ends) {
      const double middle = std::midpoint(begin, end);
      const bool is_within_step = std::floor(begin) + 1.0 >= end;
      const bool is_step = begin == std::floor(begin) && end == std::floor(end);
      if (is_within_step && !is_step && end - begin > kShort &&
          std::ranges::none_of(found.pieces, [middle](const TimePiece& one) {
            return one.begin < middle && middle < one.end;
          })) {
        add_place(middle, found.places, {.of = {}, .is_for_peaks = true});
      }
      begin = end;
    }
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

  const Mechanism& mechanism_;
  const FoundMotion& motion_;
  const SpecialSteps& special_;
  const ValuesAt& values_at_;
  MotionPositions seeking_;
  MotionPositions reading_;
  FollowedConfigurations& configurations_;
  std::vector<double> steps_;
  std::vector<double> rows_;   // at which a curve is at one of its points
  std::vector<double> jumps_;  // of springs
  FrictionRests rests_;
};

}  // namespace

Corners find_corners(const Mechanism& mechanism,
                     const FoundMotion& motion,
                     const MotionDetail& detail,
                     const SpecialSteps& special,
                     const ValuesAt& values_at,
                     FollowedConfigurations& configurations) {
  const bool has_any = !mechanism.curves.empty() || motion.plan.schedule ||
                       !mechanism.frictions.empty() || !mechanism.springs.empty() ||
                       !mechanism.geometry.other_flanks.empty() || !special.poles.empty() ||
                       has_sharp_bends(special.rates);
  return has_any
             ? CornerFinder(mechanism, motion, detail, special, values_at, configurations).find()
             : Corners{};
}

}  // namespace kinestat
