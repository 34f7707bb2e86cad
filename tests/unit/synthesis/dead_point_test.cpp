// What is said of a linkage in a dead point must not hang on how its numbers round.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/synthesis_tolerance.hpp"
#include "studies/synthesis/linkages/verdict.hpp"
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

PositionJets position_of(const Pose& pose) {
  return finite_position(pose.origin, pose.angle);
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

      EXPECT_EQ(curve.transmission_of(pose).side, 0);
      EXPECT_EQ(curve.transmission_of(pose).angle, kPi);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Linkages,
                         DeadPoint,
                         testing::Values(&stretched, &stretched_to_slider, &across_guide));

// The crank leads the rocker from a dead point to either side of it.
TEST(BranchOfADeadPoint, IsThatOfItsNeighbours) {
  for (const Point& at : kPlaces) {
    for (const double angle : directions()) {
      SCOPED_TRACE(testing::Message() << at << " direction " << angle);
      const auto [linkage, pose] = stretched(at, angle);
      const DriveCurve crank(linkage, Drive::one);
      const double x = crank.coordinate_of(pose);
      const int side = crank.transmission_of(pose).side;
      const PositionJets dead = position_of(pose);
      const PositionJets before = position_of(*crank.pose_at(x - 0.3, side));
      const PositionJets after = position_of(*crank.pose_at(x + 0.3, side));
      const auto verdict_of = [&](const std::vector<PositionJets>& positions) {
        return find_verdict(linkage, Drive::other, positions);
      };

      for (const PositionJets& other : {before, after}) {
        for (const DriveVerdict& verdict : {verdict_of({dead, other}), verdict_of({other, dead})}) {
          EXPECT_TRUE(verdict.same_circuit);
          EXPECT_TRUE(verdict.same_branch);
          EXPECT_NE(verdict.passage, Passage::none);
        }
      }
      EXPECT_FALSE(verdict_of({before, dead, after}).same_branch);
    }
  }
}

// With a crank that is shorter by more than the coordinates may round, the links are those of a
// crank-rocker: 1 - d + 2 is less than 1 + 2.
TEST(GrashofClassOfRoundedLengths, IsACrankRockerWhereTheDifferenceIsNoRounding) {
  for (const Point& at : kPlaces) {
    FourBarLengths lengths = *lengths_of(
        {.one = {.circle_point = {0.0, 0.0}, .centre_point = at, .length = 1.0},
         .other = {
             .circle_point = {2.0, 0.0}, .centre_point = at + Point(2.0, 0.0), .length = 1.0}});
    lengths.crank_one -= 2.0 * std::max(lengths.bound, kChangePoint * 6.0);

    EXPECT_EQ(classify(lengths).kind, GrashofClass::crank_rocker) << at;
  }
}

// In a parallelogram all links are in line at x = 0 and π, where its halves and sides meet.
TEST(BranchOfAChangePoint, IsThatOfItsNeighbours) {
  for (const Point& at : kPlaces) {
    for (const double angle : directions()) {
      const Linkage linkage{.one = {.circle_point = {0.0, 0.0}, .centre_point = at, .length = 1.0},
                            .other = {.circle_point = {2.0, 0.0},
                                      .centre_point = at + 2.0 * unit_vector(angle),
                                      .length = 1.0}};

      EXPECT_EQ(classify(*lengths_of(linkage)).kind, GrashofClass::change_point);
      for (const std::vector<double>& way :
           {std::vector{0.0, 1.0, 2.0}, {-2.0, -1.0, 0.0}, {1.0, 2.0, kPi}, {-kPi, -2.0, -1.0}}) {
        SCOPED_TRACE(testing::Message() << at << " direction " << angle << " from " << way[0]);
        std::vector<PositionJets> positions;
        for (const double x : way) {
          positions.push_back(position_of({.origin = at + unit_vector(angle + x), .angle = angle}));
        }

        const DriveVerdict verdict = find_verdict(linkage, Drive::one, positions);

        EXPECT_FALSE(verdict.turns_fully);
        EXPECT_TRUE(verdict.same_circuit);
        EXPECT_TRUE(verdict.same_branch);
        EXPECT_EQ(verdict.passage, Passage::increasing);
        EXPECT_NEAR(verdict.arc, way.back() - way.front(), 1e-7);
        EXPECT_EQ(verdict.full.least, 0.0);
        EXPECT_EQ(verdict.full.most, kPi);
      }
    }
  }
}

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

// Through a crank across the path of its slider, to either side, it transmits the same.
TEST(EqualWays, LeaveTheShorterOne) {
  for (const Point& at : kPlaces) {
    for (const double angle : directions()) {
      const Point path = unit_vector(angle);
      const Linkage linkage{.one = {.circle_point = {0.0, 0.0}, .centre_point = at, .length = 1.0},
                            .other = {.kind = DyadKind::slider,
                                      .circle_point = {2.5, 0.0},
                                      .centre_point = at + 3.1 * path,
                                      .direction = path}};
      const DriveCurve curve(linkage, Drive::one);
      for (const double x : {0.9, 2.1}) {
        SCOPED_TRACE(testing::Message() << at << " direction " << angle << " from " << x);
        const std::vector<PositionJets> positions = {position_of(*curve.pose_at(-x, 1)),
                                                     position_of(*curve.pose_at(x, 1))};

        const DriveVerdict verdict = find_verdict(linkage, Drive::one, positions);

        EXPECT_NEAR(verdict.arc, x < 0.5 * kPi ? 2.0 * x : 2.0 * x - 2.0 * kPi, 1e-7);
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
