#include "studies/motion/task/figures/curve_corners.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/dense/root_search.hpp"
#include "studies/motion/motion.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kMostCorners = 10000;

class CornerFinder {
 public:
  CornerFinder(const Mechanism& mechanism,
               const FoundMotion& motion,
               const MotionDetail& detail,
               const ValuesAt& values_at)
      : mechanism_(mechanism),
        motion_(motion),
        values_at_(values_at),
        seeking_(mechanism, motion.plan, motion.network, motion.drawn, seeking_detail(mechanism)),
        reading_(mechanism, motion.plan, motion.network, motion.drawn, detail),
        way_(motion.network, motion.solution) {}

  std::vector<FigurePlace> find() {
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
    std::ranges::sort(steps_);
    std::vector<FigurePlace> corners;
    for (const double step : steps_) {
      add_place(step, corners);
    }
    add_breaks(corners);
    std::ranges::stable_sort(corners, {}, &FigurePlace::step);
    return corners;
  }

 private:
  // Speeds are only looked at where a curve is over one.
  static MotionDetail seeking_detail(const Mechanism& mechanism) {
    MotionDetail detail;
    detail.velocity = std::ranges::any_of(
        mechanism.curves, [](const Curve& one) { return one.over == Curve::Over::speed; });
    return detail;
  }

  // Empty where the motion cannot be followed to there.
  std::optional<MotionPosition> position_at(double step,
                                            MotionPositions& positions,
                                            std::optional<double> at = {}) {
    const double row = std::min(std::floor(step), motion_.solution.position_count() - 1.0);
    const double share = share_at_step(motion_, step);
    const double begin = motion_.solution.shares[static_cast<std::size_t>(row)];
    std::optional<Configuration> there = motion_.solution.configuration_at(static_cast<int>(row));
    if (share > begin) {
      there = way_.follow(*there, begin, share);
    }
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
        return position->has_speeds()
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

  const Mechanism& mechanism_;
  const FoundMotion& motion_;
  const ValuesAt& values_at_;
  MotionPositions seeking_;
  MotionPositions reading_;
  WayBetween way_;
  std::vector<double> steps_;
};

}  // namespace

double share_at_step(const FoundMotion& motion, double step) {
  if (motion.plan.schedule) {
    return motion.plan.schedule->share_at(step / motion.plan.steps);
  }
  const std::vector<double>& shares = motion.solution.shares;
  const auto row = static_cast<std::size_t>(step);
  return row + 1 < shares.size() ? std::lerp(shares[row], shares[row + 1], step - std::floor(step))
                                 : shares.back();
}

std::vector<FigurePlace> find_curve_corners(const Mechanism& mechanism,
                                            const FoundMotion& motion,
                                            const MotionDetail& detail,
                                            const ValuesAt& values_at) {
  return mechanism.curves.empty() && !motion.plan.schedule
             ? std::vector<FigurePlace>()
             : CornerFinder(mechanism, motion, detail, values_at).find();
}

}  // namespace kinestat
