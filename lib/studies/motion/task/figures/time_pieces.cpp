#include "studies/motion/task/figures/time_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/motion_tolerance.hpp"
#include "math/dense/legendre_pieces.hpp"

namespace kinestat {

namespace {

constexpr int kLeastPoints = 4;
constexpr int kMostPoints = 8;
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

class PointCounter {
 public:
  PointCounter(const DriveSchedule& schedule, int steps) : schedule_(schedule), steps_(steps) {}

  // None where all drives rest.
  int count(double begin, double end) const {
    const std::vector<double> finest = mean_squares(begin, end, kMostPoints);
    if (std::ranges::all_of(finest, [](double one) { return one == 0.0; })) {
      return 0;
    }
    int count = kLeastPoints;
    while (count < kMostPoints && !agree(mean_squares(begin, end, count), finest)) {
      ++count;
    }
    // Of what else the mechanism does in so many steps.
    const int least = static_cast<int>(std::ceil(kPointsOfSteps * (end - begin)));
    return std::min(std::max(count, least), kMostPoints);
  }

 private:
  static constexpr double kPointsOfSteps = 0.5;

  static bool agree(const std::vector<double>& some, const std::vector<double>& finest) {
    constexpr double kAgree = 0x1p-17;
    return std::ranges::equal(some, finest, [](double one, double other) {
      return std::abs(one - other) <= kAgree * other;
    });
  }

  // Of the speed and the acceleration of each drive.
  std::vector<double> mean_squares(double begin, double end, int count) const {
    std::vector<double> sums(2 * schedule_.drive_count(), 0.0);
    for (const TimePoint& point : piece_of(begin, end, count).points) {
      for (std::size_t d = 0; d < schedule_.drive_count(); ++d) {
        const DriveInstant now = schedule_.at(d, point.step / steps_);
        sums[2 * d] += point.weight * now.speed * now.speed;
        sums[2 * d + 1] += point.weight * now.acceleration * now.acceleration;
      }
    }
    return sums;
  }

  const DriveSchedule& schedule_;
  double steps_;
};

}  // namespace

std::vector<TimePiece> find_time_pieces(const DriveSchedule& schedule,
                                        int steps,
                                        double last_step,
                                        std::span<const double> corners) {
  // So many steps for each point show as much as these.
  constexpr double kStepsOfPoint = 2.0;
  const PointCounter counter(schedule, steps);
  std::vector<double> ends;
  for (const double time : schedule.corners()) {
    ends.push_back(std::min(time * steps, last_step));
  }
  ends.push_back(last_step);
  std::vector<TimePiece> pieces;
  double begin = 0.0;
  auto next = corners.begin();
  for (const double end : ends) {
    const double width = end - begin;
    const int whole =
        width > kSameStep && width < kStepsOfPoint * kMostPoints ? counter.count(begin, end) : 0;
    const bool needs_points = width < kStepsOfPoint * whole;
    for (double from = begin; from < end;) {
      while (next != corners.end() && *next <= from + kSameStep) {
        ++next;
      }
      const double to = next != corners.end() && *next < end - kSameStep ? *next : end;
      const int count = needs_points && to - from > kSameStep ? counter.count(from, to) : 0;
      if (count > 0 && pieces.size() < kMostPieces) {
        pieces.push_back(piece_of(from, to, count));
      }
      from = to;
    }
    begin = end;
  }
  return pieces;
}

}  // namespace kinestat
