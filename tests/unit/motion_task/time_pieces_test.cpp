// Points of Gauss between the corners of a law, against its closed forms.
#include "studies/motion/task/figures/time_pieces.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// A slide of 1 m in a quarter of the time, between rests.
MotionPlan plan_of(DriveLaw law, int steps) {
  MotionPlan plan;
  plan.drives.push_back({.actuator = 0, .freedom = 0, .from = 0.0, .to = 1.0, .where = {}});
  plan.steps = steps;
  DriveCourse course{.from = 0.0, .to = 1.0};
  course.parts = {{.begin = 0.0, .end = 0.25, .from = 0.0, .to = 0.0},
                  {.begin = 0.25, .end = 0.5, .from = 0.0, .to = 1.0, .law = law},
                  {.begin = 0.5, .end = 1.0, .from = 1.0, .to = 1.0}};
  plan.schedule.emplace(1.0, std::vector<DriveCourse>{course});
  return plan;
}

Topology sliding() {
  Topology topology;
  topology.freedoms.emplace_back();
  topology.freedoms.back().is_rotation = false;
  return topology;
}

TEST(TimePieces, HaveTheMeanSquaresOfTheLaw) {
  const Topology topology = sliding();
  for (const int steps : {1, 4, 24}) {
    const MotionPlan plan = plan_of(DriveLaw::cycloidal, steps);
    const auto pieces = find_time_pieces(topology, plan, steps, {});
    ASSERT_FALSE(pieces.empty()) << steps;
    double way = 0.0;
    double square = 0.0;
    double weight = 0.0;
    for (const TimePiece& piece : pieces) {
      for (const TimePoint& point : piece.points) {
        EXPECT_GT(point.step, piece.begin);
        EXPECT_LT(point.step, piece.end);
        const double speed = plan.schedule->at(0, point.step / steps).speed;
        way += point.weight / steps * speed;
        square += point.weight / steps * speed * speed;
        weight += point.weight;
      }
    }
    // The speed is (1 - cos(2 pi u)) / T: its mean square 3/2 / T^2.
    EXPECT_NEAR(weight, 0.25 * steps, 1e-12) << steps;
    EXPECT_NEAR(way, 1.0, 1e-6) << steps;
    EXPECT_NEAR(square, 1.5 / 0.25, 1e-4) << steps;
  }
}

TEST(TimePieces, AreNoneWhereRowsShowTheLaw) {
  EXPECT_TRUE(find_time_pieces(sliding(), plan_of(DriveLaw::cycloidal, 4000), 4000.0, {}).empty());
}

TEST(TimePieces, EndAtOtherCorners) {
  const std::vector<double> corners = {3.5};
  const auto pieces =
      find_time_pieces(sliding(), plan_of(DriveLaw::polynomial_345, 10), 10.0, corners);
  ASSERT_GE(pieces.size(), 2U);
  EXPECT_DOUBLE_EQ(pieces.front().begin, 2.5);
  EXPECT_DOUBLE_EQ(pieces.back().end, 5.0);
  bool ends_there = false;
  for (const TimePiece& piece : pieces) {
    EXPECT_FALSE(piece.begin < 3.5 && piece.end > 3.5);
    ends_there = ends_there || piece.end == 3.5;
  }
  EXPECT_TRUE(ends_there);
}

}  // namespace
}  // namespace kinestat
