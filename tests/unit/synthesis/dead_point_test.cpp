// What is said of a linkage in a dead point must not hang on how its numbers round.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "studies/synthesis/linkages/drive_curve.hpp"
#include "support/angles.hpp"

namespace kinestat {
namespace {

// Where linkages stand, with coordinates that are no round numbers.
const std::vector<Point> kPlaces = {{0.0, 0.0}, {0.37, -1.3}, {31234.7, -977.1}, {-3.1e7, 2.3e7}};

// Turned all over.
std::vector<double> directions() {
  std::vector<double> result;
  for (int i = 0; i < 50; ++i) {
    result.push_back(0.12 * i - 3.0);
  }
  return result;
}

struct InDeadPoint {
  Linkage linkage;
  Pose pose;
};

// Driven at the rocker: crank, of length 1, and coupler, of length 3, are in line.
InDeadPoint stretched(const Point& at, double angle) {
  const Point along = unit_vector(angle);
  const Point centre = at + Point(2.5, 2.0) * along;
  return {.linkage = {.one = {.circle_point = {0.0, 0.0}, .centre_point = at, .length = 1.0},
                      .other = {.circle_point = {3.0, 0.0}, .centre_point = centre, .length = 2.5}},
          .pose = {.origin = at + along, .angle = angle}};
}

// The same with a slider that is driven.
InDeadPoint stretched_to_slider(const Point& at, double angle) {
  InDeadPoint result = stretched(at, angle);
  result.linkage.other = {.kind = DyadKind::slider,
                          .circle_point = {3.0, 0.0},
                          .centre_point = at + 4.0 * unit_vector(angle),
                          .direction = unit_vector(angle + 0.4)};
  return result;
}

// Driven at the guide of an inverted slider, across whose line the crank lies.
InDeadPoint across_guide(const Point& at, double angle) {
  InDeadPoint result = stretched(at, angle);
  result.pose.angle = angle - 0.5 * kPi;
  result.linkage.other = {
      .kind = DyadKind::inverted_slider,
      .circle_point = {0.0, 0.3},
      .centre_point = result.pose.place({2.0, 0.3}),
  };
  return result;
}

class DeadPoint : public testing::TestWithParam<InDeadPoint (*)(const Point&, double)> {};

TEST_P(DeadPoint, IsOnNoSide) {
  for (const Point& at : kPlaces) {
    for (const double angle : directions()) {
      SCOPED_TRACE(testing::Message() << at << " direction " << angle);
      const auto [linkage, pose] = GetParam()(at, angle);
      const DriveCurve curve(linkage, Drive::other);

      EXPECT_EQ(curve.side_of(pose), 0);
      EXPECT_EQ(curve.transmission_of(pose), kPi);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Linkages,
                         DeadPoint,
                         testing::Values(&stretched, &stretched_to_slider, &across_guide));

// The circle point of the driven dyad is the pole.
TEST(SenseInADeadPoint, IsNone) {
  const Point circle_point(1.1, 0.7);
  for (const Point& at : kPlaces) {
    for (const double angle : directions()) {
      SCOPED_TRACE(testing::Message() << at << " direction " << angle);
      const Point arm = unit_vector(angle) * circle_point;
      const Point origin = at - arm;
      const Point speed = -0.3 * left_of(arm);
      const PositionJets position{.x = {origin.real(), speed.real()},
                                  .y = {origin.imag(), speed.imag()},
                                  .angle = {angle, 0.3},
                                  .is_directed = true};
      for (const DyadKind kind : {DyadKind::crank, DyadKind::slider}) {
        const Dyad driven{.kind = kind,
                          .circle_point = circle_point,
                          .centre_point = at + Point(1.5, 0.8),
                          .direction = unit_vector(0.7),
                          .length = 1.7};
        const Dyad crank{.centre_point = at, .length = std::abs(arm)};

        EXPECT_EQ(DriveCurve({.one = crank, .other = driven}, Drive::other).sense_of(position), 0);
      }
    }
  }
}

// Directions that are parallel but for rounding.
TEST(ParallelDyads, HaveNoDeadPoint) {
  for (const double angle : directions()) {
    SCOPED_TRACE(angle);
    const Point along = unit_vector(angle);
    const Point same = -unit_vector(angle + kPi);
    for (const DyadKind kind : {DyadKind::slider, DyadKind::inverted_slider}) {
      const Linkage linkage{.one = {.kind = kind, .direction = along},
                            .other = {.kind = kind,
                                      .circle_point = 2.0 * left_of(along),
                                      .centre_point = 1.2 * left_of(along),
                                      .direction = same}};
      const DriveCurve curve(linkage, Drive::one);

      EXPECT_TRUE(std::isinf(curve.range().low));
      EXPECT_TRUE(std::isinf(curve.range().high));
      EXPECT_EQ(curve.range().low_transmission, curve.range().high_transmission);
      if (kind == DyadKind::inverted_slider) {
        EXPECT_EQ(curve.transmission(0.3), 0.0);
      }
    }
  }
}

}  // namespace
}  // namespace kinestat
