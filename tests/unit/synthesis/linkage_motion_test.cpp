#include "studies/synthesis/linkages/linkage_motion.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "known_linkage.hpp"
#include "studies/synthesis/linkages/verdict.hpp"
#include "support/angles.hpp"

namespace kinestat {
namespace {

// Ground 4, crank 1, coupler 3.5, rocker 2.5; its moving frame at the crank pin, along the coupler.
Linkage crank_rocker(double coupler) {
  return {.one = {.circle_point = {0.0, 0.0}, .centre_point = {0.0, 0.0}, .length = 1.0},
          .other = {.circle_point = {coupler, 0.0}, .centre_point = {4.0, 0.0}, .length = 2.5}};
}

double breach(const Linkage& linkage, const Pose& pose) {
  double worst = 0.0;
  for (const Dyad& dyad : {linkage.one, linkage.other}) {
    const double distance = std::abs(pose.place(dyad.circle_point) - dyad.centre_point);
    worst = std::max(worst, std::abs(distance - dyad.length));
  }
  return worst;
}

// Driven at the rocker, which has dead points: rounding puts the cosine there now and then above 1.
TEST(LinkageMotion, HasItsDeadPointsAndAsManyPosesAsAskedFor) {
  for (int i = 0; i < 200; ++i) {
    const Linkage linkage = crank_rocker(3.5 + 0.001 * i);
    SCOPED_TRACE(i);
    const Pose start = *DriveCurve(linkage, Drive::one).pose_at(0.7, 1);

    const LinkageMotion motion = trace_circuit(linkage, Drive::other, start, 24, 20.0);

    EXPECT_TRUE(motion.is_closed);
    EXPECT_EQ(motion.poses.size(), 24U);
    for (const Pose& pose : motion.poses) {
      EXPECT_LT(breach(linkage, pose), 1e-11);
    }
  }
}

// In a dead point of the rocker crank and coupler are in line, here along x.
TEST(LinkageMotion, StartsInADeadPoint) {
  const Linkage linkage{
      .one = {.circle_point = {0.0, 0.0}, .centre_point = {0.0, 0.0}, .length = 1.0},
      .other = {.circle_point = {3.0, 0.0}, .centre_point = {2.5, 2.0}, .length = 2.5}};
  const Pose start{.origin = {1.0, 0.0}, .angle = 0.0};
  ASSERT_EQ(DriveCurve(linkage, Drive::other).transmission_of(start).side, 0);

  const LinkageMotion motion = trace_circuit(linkage, Drive::other, start, 40, 20.0);

  EXPECT_EQ(motion.poses.size(), 40U);
  for (const Pose& pose : motion.poses) {
    EXPECT_LT(breach(linkage, pose), 1e-11);
  }
}

// A crank that almost stops near dead points of the other side: the coupler runs there.
TEST(LinkageMotion, LeavesNoGaps) {
  const Linkage linkage{
      .one = {.circle_point = {0.0, 0.0}, .centre_point = {0.0, 0.0}, .length = 1.0},
      .other = {.circle_point = {3.0, 0.0}, .centre_point = {2.0000001, 0.0}, .length = 2.0}};
  const Pose start = *DriveCurve(linkage, Drive::one).pose_at(1.0, 1);

  const LinkageMotion motion = trace_circuit(linkage, Drive::one, start, 200, 20.0);
  const std::vector<Point> path = coupler_curve(motion, {1.5, 1.0});

  double length = 0.0;
  double longest = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double step = std::abs(path[(i + 1) % path.size()] - path[i]);
    length += step;
    longest = std::max(longest, step);
  }
  ASSERT_EQ(path.size(), 200U);
  EXPECT_LT(longest, 3.0 * length / 200.0);
}

// Least sine of the transmission angle over a way, by steps of poses.
double least_sine(const DriveCurve& curve, double from, double arc) {
  double least = 1.0;
  for (int i = 0; i <= 2000; ++i) {
    least = std::min(least, std::sin(curve.transmission(from + arc * i / 2000.0)));
  }
  return least;
}

// Two positions may be passed either way round.
TEST(TwoPositions, ArePassedTheWayThatTransmitsBetter) {
  const Linkage linkage = crank_rocker(3.5);
  const DriveCurve curve(linkage, Drive::one);
  int longer = 0;
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    const double from = -3.0 + 0.37 * (i % 17);
    const double turn = 0.4 + 0.055 * i;
    std::vector<PositionJets> positions;
    for (const double x : {from, from + turn}) {
      const Pose pose = *curve.pose_at(x, 1);
      positions.push_back(finite_position(pose.origin, pose.angle));
    }

    const DriveVerdict verdict = find_verdict(linkage, Drive::one, positions);

    const double other = verdict.arc > 0.0 ? verdict.arc - 2.0 * kPi : verdict.arc + 2.0 * kPi;
    EXPECT_GE(least_sine(curve, from, verdict.arc), least_sine(curve, from, other) - 1e-9);
    longer += std::abs(verdict.arc) > kPi ? 1 : 0;
  }
  EXPECT_GT(longer, 5);
}

}  // namespace
}  // namespace kinestat
