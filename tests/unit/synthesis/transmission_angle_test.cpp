#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "known_linkage.hpp"
#include "studies/synthesis/linkages/verdict.hpp"
#include "support/angles.hpp"

namespace kinestat {
namespace {

constexpr double kSlack = 0x1p-40;

// One dyad is a crank of length 1; the moving frame is at its pin, along the coupler.
Linkage four_bar(double ground, double coupler, double rocker) {
  return {
      .one = {.circle_point = {0.0, 0.0}, .centre_point = {0.0, 0.0}, .length = 1.0},
      .other = {.circle_point = {coupler, 0.0}, .centre_point = {ground, 0.0}, .length = rocker}};
}

PositionJets position_at(const Linkage& linkage, double x) {
  const Pose pose = *DriveCurve(linkage, Drive::one).pose_at(x, 1);
  return finite_position(pose.origin, pose.angle);
}

TransmissionRange full_range(const Linkage& linkage, Drive drive) {
  const std::vector<PositionJets> positions = {position_at(linkage, 1.0)};
  return find_verdict(linkage, drive, positions).full;
}

// With the pin beyond the frame, coupler and rocker all but stretched: by the law of cosines
// (ρ + h + k)(h + k - ρ) = 4 h k cos²(μ/2), in which all lengths are exact.
TEST(TransmissionAngle, KeepsItsDigitsNextToAStretchedPosition) {
  const double k = 2.0 + kSlack;

  const double found = full_range(four_bar(4.0, 3.0, k), Drive::one).most;

  const double left = 2.0 * std::asin(std::sqrt(kSlack * (10.0 + kSlack) / (12.0 * k)));
  EXPECT_NEAR(found, kPi - left, 1e-15);
}

// With the pin towards the rocker, coupler and rocker all but folded:
// (ρ + h - k)(ρ - h + k) = 4 h k sin²(μ/2).
TEST(TransmissionAngle, KeepsItsDigitsNextToAFoldedPosition) {
  const double k = 3.0 + kSlack;

  const double found = full_range(four_bar(3.0, 5.0, k), Drive::one).least;

  const double expected = 2.0 * std::asin(std::sqrt(kSlack * (4.0 - kSlack) / (20.0 * k)));
  EXPECT_NEAR(found, expected, 1e-14 * expected);
}

TEST(TransmissionAngle, IsZeroAndAHalfTurnInDeadPoints) {
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const TransmissionRange range = full_range(four_bar(4.0, 3.5 + 0.001 * i, 2.5), Drive::other);

    EXPECT_EQ(range.least, 0.0);
    EXPECT_EQ(range.most, kPi);
  }
}

// The rocker's centre is so placed that rocker and coupler meet at the angle that is asked for.
TEST(TransmissionAngle, KeepsItsDigitsInPositions) {
  for (const double angle : {1e-12, 1e-9, 1e-5, 0.1}) {
    for (const double side : {1.0, -1.0}) {
      SCOPED_TRACE(angle * side);
      const Linkage linkage{
          .one = {.circle_point = {0.0, 0.0}, .centre_point = {0.0, 0.0}, .length = 1.0},
          .other = {.circle_point = {3.0, 0.0},
                    .centre_point = {4.0 - 2.0 * side * std::cos(angle), 2.0 * std::sin(angle)},
                    .length = 2.0}};
      const std::vector<PositionJets> positions = {finite_position({1.0, 0.0}, 0.0)};

      const double found = find_verdict(linkage, Drive::one, positions).transmission[0];

      EXPECT_NEAR(found, side > 0.0 ? angle : kPi - angle, side > 0.0 ? 1e-15 * angle : 1e-15);
    }
  }
}

class LinkagesOfAllKinds : public testing::TestWithParam<std::tuple<DyadKind, DyadKind>> {};

// Between the lines of the poses, which stem from none of the closed forms.
TEST_P(LinkagesOfAllKinds, HaveTheAngleOfTheirPoses) {
  Random random(20260925);
  const auto [one, other] = GetParam();
  int count = 0;
  for (int i = 0; i < 200; ++i) {
    const KnownLinkage known = random_linkage(random, one, other);
    const Linkage linkage{.one = known.one, .other = known.other};
    const DriveCurve curve(linkage, Drive::one);
    const DriveCurve::Range range = curve.range();
    const double least = std::min(range.low_transmission, range.high_transmission);
    const double most = std::max(range.low_transmission, range.high_transmission);
    for (const double angle : {-2.0, 0.3, 1.7}) {
      for (const Point& origin : known.origins(angle)) {
        const Pose pose{.origin = origin, .angle = angle};
        const double found = curve.transmission_of(pose).angle;
        // Next to dead points the angle is as the root of what rounds the coordinate.
        if (std::sin(found) < 1e-3) {
          continue;
        }
        EXPECT_NEAR(curve.transmission(curve.coordinate_of(pose)), found, 1e-10);
        EXPECT_GE(found, least - 1e-10);
        EXPECT_LE(found, most + 1e-10);
        ++count;
      }
    }
  }
  EXPECT_GT(count, 50);
}

INSTANTIATE_TEST_SUITE_P(
    TransmissionAngle,
    LinkagesOfAllKinds,
    testing::Combine(
        testing::Values(DyadKind::crank, DyadKind::slider, DyadKind::inverted_slider),
        testing::Values(DyadKind::crank, DyadKind::slider, DyadKind::inverted_slider)));

}  // namespace
}  // namespace kinestat
