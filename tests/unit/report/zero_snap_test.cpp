#include "report/zero_snap.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/tolerance.hpp"

namespace kinestat {
namespace {

constexpr double kLength = 2.0;  // of the mechanism [m]

Twist twist(double angular, double linear) {
  return {.angular = Vec3(0.0, 0.0, angular), .linear = Vec3(linear, 0.0, 0.0)};
}

CaseAnalysis moving(const Twist& motion) {
  CaseAnalysis analysis;
  analysis.motion = KinematicSolution{};
  analysis.motion->bodies = {Twist{}, motion};
  return analysis;
}

TEST(Snap, WritesWhatIsBelowTheThresholdAsPlusZero) {
  EXPECT_FALSE(std::signbit(snap(-1e-16, 1e-15)));
  EXPECT_EQ(snap(-1e-16, 1e-15), 0.0);
}

TEST(Snap, TakesTheThresholdItselfForRounding) {
  EXPECT_EQ(snap(1e-15, 1e-15), 0.0);
}

TEST(Snap, KeepsWhatIsAboveTheThreshold) {
  EXPECT_EQ(snap(-2e-15, 1e-15), -2e-15);
}

TEST(Snap, KeepsEverythingButZeroWithoutAThreshold) {
  EXPECT_EQ(snap(5e-324, 0.0), 5e-324);
}

TEST(ZeroSnap, IsZeroForACaseWithoutPasses) {
  const ZeroSnap zero = find_zero_snap(CaseAnalysis{}, kLength);

  EXPECT_EQ(zero.angular, 0.0);
  EXPECT_EQ(zero.force, 0.0);
  EXPECT_EQ(zero.power, 0.0);
}

TEST(ZeroSnap, OfALinearVelocityCountsTheAngularOneTimesTheLength) {
  const ZeroSnap zero = find_zero_snap(moving(twist(10.0, 3.0)), kLength);

  EXPECT_DOUBLE_EQ(zero.linear, kReportZero * 20.0);
  EXPECT_DOUBLE_EQ(zero.angular, kReportZero * 10.0);
}

TEST(ZeroSnap, OfAnAngularVelocityCountsTheLinearOneByTheLength) {
  const ZeroSnap zero = find_zero_snap(moving(twist(1.0, 8.0)), kLength);

  EXPECT_DOUBLE_EQ(zero.angular, kReportZero * 4.0);
  EXPECT_DOUBLE_EQ(zero.linear, kReportZero * 8.0);
}

TEST(ZeroSnap, OfAMotionLooksAtCouplingsToo) {
  CaseAnalysis analysis = moving(twist(1.0, 0.0));
  analysis.motion->couplings = {twist(-5.0, 0.0)};

  EXPECT_DOUBLE_EQ(find_zero_snap(analysis, kLength).angular, kReportZero * 5.0);
}

TEST(ZeroSnap, OfActionsPassesOverWhatIsNotDetermined) {
  CaseAnalysis analysis;
  analysis.action = StaticSolution{};
  analysis.action->wrenches = {std::nullopt,
                               Wrench{.moment = Vec3::Zero(), .force = Vec3(0.0, -3.0, 0.0)}};

  const ZeroSnap zero = find_zero_snap(analysis, kLength);

  EXPECT_DOUBLE_EQ(zero.force, kReportZero * 3.0);
  EXPECT_DOUBLE_EQ(zero.moment, kReportZero * 6.0);
}

TEST(ZeroSnap, OfPowerIsAShareOfTheLargestPower) {
  CaseAnalysis analysis;
  analysis.power = PowerFlow{};
  analysis.power->into_head = {1.0, -40.0};
  analysis.power->supplied = {30.0, 0.0};

  EXPECT_DOUBLE_EQ(find_zero_snap(analysis, kLength).power, kReportZero * 40.0);
}

}  // namespace
}  // namespace kinestat
