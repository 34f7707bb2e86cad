#include "studies/motion/task/figures/time_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/extreme_tolerance.hpp"
#include "core/motion_tolerance.hpp"
#include "math/dense/legendre_pieces.hpp"

namespace kinestat {

namespace {

constexpr int kLeastPoints = 4;
constexpr int kMostPoints = 32;

// Of each turn of a drive: that need no points beside them, and if they do.
constexpr double kRowsOfTurn = 24.0;
constexpr double kPointsOfTurn = 36.0;
constexpr std::size_t kMostPieces = 100;

const GaussPoints& rule_of(int count) {
  static const std::array<GaussPoints, kMostPoints + 1> rules = [] {
    std::array<GaussPoints, kMostPoints + 1> all;
    for (int one = kLeastPoints; one <= kMostPoints; ++one) {
      all[static_cast<std::size_t>(one)] = gauss_points(one);
    }
    return all;
  }();
  return rules[static_cast<std::size_t>(count)];
}

TimePiece piece_of(double begin, double end, int count) {
  const GaussPoints& rule = rule_of(count);
  TimePiece piece{.begin = begin, .end = end};
  const double half = 0.5 * (end - begin);
  for (int i = 0; i < count; ++i) {
    piece.points.push_back(
        {.step = begin + half * (1.0 + rule.points[i]), .weight = half * rule.weights[i]});
  }
  return piece;
}

// In equal parts where there are more points than one rule has.
void add_pieces(double begin, double end, int count, std::vector<TimePiece>& pieces) {
  const int parts = (count + kMostPoints - 1) / kMostPoints;
  const int each = std::max((count + parts - 1) / parts, kLeastPoints);
  for (int i = 0; i < parts; ++i) {
    pieces.push_back(piece_of(std::lerp(begin, end, static_cast<double>(i) / parts),
                              std::lerp(begin, end, static_cast<double>(i + 1) / parts),
                              each));
  }
}

class PointCounter {
 public:
  PointCounter(const Topology& topology, const MotionPlan& plan)
      : schedule_(*plan.schedule), steps_(plan.steps) {
    for (std::size_t d = 0; d < plan.drives.size(); ++d) {
      const auto freedom = static_cast<std::size_t>(plan.drives[d].freedom);
      ways_.push_back(topology.freedoms[freedom].is_rotation ? 2.0 * std::numbers::pi : way(d));
    }
  }

  // Whether rows so near each other do not show what is between two places.
  bool needs_points(double begin, double end) const {
    // So many steps for each point show as much as these.
    constexpr double kStepsOfPoint = 2.0;
    const double width = end - begin;
    return width < kStepsOfPoint * points_of_law(begin, end) ||
           width < kRowsOfTurn * turns(begin, end);
  }

  // None where all drives rest.
  int count(double begin, double end) const {
    const int of_law = points_of_law(begin, end);
    return of_law == 0
               ? 0
               : std::max(of_law, static_cast<int>(std::ceil(kPointsOfTurn * turns(begin, end))));
  }

 private:
  double position(std::size_t drive, double step) const {
    return schedule_.at(drive, step / steps_).position;
  }

  int points_of_law(double begin, double end) const {
    const std::vector<double> finest = mean_squares(begin, end, kMostPoints);
    if (std::ranges::all_of(finest, [](double one) { return one == 0.0; })) {
      return 0;
    }
    int count = kLeastPoints;
    while (count < kMostPoints && !agree(mean_squares(begin, end, count), finest)) {
      ++count;
    }
    return count;
  }

  // The most that a drive moves.
  double turns(double begin, double end) const {
    double most = 0.0;
    for (std::size_t d = 0; d < ways_.size(); ++d) {
      const double moved = std::abs(position(d, end) - position(d, begin));
      most = std::max(most, moved > 0.0 ? moved / ways_[d] : 0.0);
    }
    return most;
  }

  // From one end of what it passes to the other.
  double way(std::size_t drive) const {
    double least = position(drive, 0.0);
    double greatest = least;
    for (const double turn : schedule_.turns()) {
      const double there = schedule_.at(drive, turn).position;
      least = std::min(least, there);
      greatest = std::max(greatest, there);
    }
    const double last = position(drive, steps_);
    return std::max(greatest, last) - std::min(least, last);
  }

  static bool agree(const std::vector<double>& some, const std::vector<double>& finest) {
    return std::ranges::equal(some, finest, [](double one, double other) {
      return std::abs(one - other) <= kMeansAgree * other;
    });
  }

  // Of the speed, the acceleration and their product, the power of a mass, of each drive.
  std::vector<double> mean_squares(double begin, double end, int count) const {
    std::vector<double> sums(3 * schedule_.drive_count(), 0.0);
    for (const TimePoint& point : piece_of(begin, end, count).points) {
      for (std::size_t d = 0; d < schedule_.drive_count(); ++d) {
        const DriveInstant now = schedule_.at(d, point.step / steps_);
        const double power = now.speed * now.acceleration;
        sums[3 * d] += point.weight * now.speed * now.speed;
        sums[3 * d + 1] += point.weight * now.acceleration * now.acceleration;
        sums[3 * d + 2] += point.weight * power * power;
      }
    }
    return sums;
  }

  const DriveSchedule& schedule_;
  double steps_;
  std::vector<double> ways_;  // of each drive: a turn, or all of it
};

}  // namespace

std::vector<TimePiece> find_time_pieces(const Topology& topology,
                                        const MotionPlan& plan,
                                        double last_step,
                                        std::span<const double> corners) {
  const PointCounter counter(topology, plan);
  const DriveSchedule& schedule = *plan.schedule;
  const int steps = plan.steps;
  std::vector<double> ends;
  for (const double time : schedule.corners()) {
    ends.push_back(std::min(time * steps, last_step));
  }
  ends.push_back(last_step);
  std::vector<TimePiece> pieces;
  double begin = 0.0;
  auto next = corners.begin();
  for (const double end : ends) {
    const bool needs_points = end - begin > kSameStep && counter.needs_points(begin, end);
    for (double from = begin; from < end;) {
      while (next != corners.end() && *next <= from + kSameStep) {
        ++next;
      }
      const double to = next != corners.end() && *next < end - kSameStep ? *next : end;
      const int count = needs_points && to - from > kSameStep ? counter.count(from, to) : 0;
      if (count > 0 && pieces.size() < kMostPieces) {
        add_pieces(from, to, count, pieces);
      }
      from = to;
    }
    begin = end;
  }
  return pieces;
}

}  // namespace kinestat
