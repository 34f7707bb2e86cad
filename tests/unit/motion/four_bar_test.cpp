#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "studies/motion/hermite_cubic.hpp"
#include "support/angles.hpp"
#include "unit/motion/moving.hpp"

namespace kinestat {
namespace {

/// Ground from (0, 0) to (ground, 0); the coupler point lies at (along, across) on the coupler.
struct FourBar {
  double crank = 1.0;
  double coupler = 3.0;
  double rocker = 2.5;
  double ground = 3.2;
  double side = 1.0;  ///< +1: open, the pin of the rocker to the left of the diagonal; -1: crossed

  Vec3 crank_pin(double angle) const {
    return {crank * std::cos(angle), crank * std::sin(angle), 0.0};
  }

  /// By the intersection of two circles.
  Vec3 rocker_pin(double angle) const {
    const Vec3 b = crank_pin(angle);
    const Vec3 d(ground, 0.0, 0.0);
    const Vec3 diagonal = d - b;
    const double length = diagonal.norm();
    const double along = (length * length + coupler * coupler - rocker * rocker) / (2.0 * length);
    const double height = std::sqrt(coupler * coupler - along * along);
    const Vec3 unit = diagonal / length;
    return b + along * unit + side * height * Vec3(-unit.y(), unit.x(), 0.0);
  }

  std::string text(double angle) const {
    const Vec3 b = crank_pin(angle);
    const Vec3 c = rocker_pin(angle);
    return fmt::format(
        "space: planar\nground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
        "  a: {{type: revolute, bodies: [frame, crank], at: [0, 0]}}\n"
        "  b: {{type: revolute, bodies: [crank, coupler], at: [{}, {}]}}\n"
        "  c: {{type: revolute, bodies: [coupler, rocker], at: [{}, {}]}}\n"
        "  d: {{type: revolute, bodies: [frame, rocker], at: [{}, 0]}}\n",
        b.x(),
        b.y(),
        c.x(),
        c.y(),
        ground);
  }
};

class FourBarTurn : public testing::TestWithParam<double> {};

// A point of the coupler against the two circles, around the whole circle, on both branches.
TEST_P(FourBarTurn, FollowsTheCouplerCurve) {
  const FourBar linkage{.side = GetParam()};
  const double start = 0.7;
  const Moving subject = moving(linkage.text(start), {"a.wz"});

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 360);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  ASSERT_EQ(solution.position_count(), 361);
  EXPECT_LE(worst_closure_error(solution), 1e-12);
  const Vec3 drawn = linkage.rocker_pin(start);
  double worst = 0.0;
  for (int k = 0; k <= 360; ++k) {
    const auto poses = body_poses(subject.network, solution.configuration_at(k));
    const Vec3 found = poses[2].point(drawn);
    worst = std::max(worst, (found - linkage.rocker_pin(start + k * kPi / 180.0)).norm());
  }
  EXPECT_LE(worst, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Branches, FourBarTurn, testing::Values(1.0, -1.0));

// 3 + 2.5 < 1.5 + 5: the crank stops where coupler and rocker are in line.
TEST(FourBar, CrankComesToItsLimit) {
  const FourBar linkage{.crank = 3.0, .coupler = 2.0, .rocker = 1.5, .ground = 4.0};
  const double start = 0.3;
  const Moving subject = moving(linkage.text(start), {"a.wz"});

  const MotionSolution solution = move(subject, 0.0, kPi, 180);

  // cos = (crank² + ground² - (coupler + rocker)²) / (2 crank ground)
  const double limit = std::acos((9.0 + 16.0 - 3.5 * 3.5) / 24.0) - start;
  ASSERT_EQ(solution.status, MotionStatus::limit);
  EXPECT_NEAR(solution.drive_value(0, solution.position_count() - 1), limit, 1e-12);
  ASSERT_FALSE(solution.special.empty());
  EXPECT_EQ(solution.special.back().kind, SpecialKind::limit);
  EXPECT_NEAR(solution.special.back().drive_values.at(0), limit, 1e-12);
}

// The rocker of a crank-rocker turns back where crank and coupler are in line: stretched one way,
// folded the other way, by the law of cosines at its pivot.
TEST(FourBar, RockerRunsToBothItsLimits) {
  const FourBar linkage{.crank = 1.0, .coupler = 3.0, .rocker = 2.5, .ground = 3.2};
  const double start = 0.7;
  const Moving subject = moving(linkage.text(start), {"d.wz"});
  const Vec3 pin = linkage.rocker_pin(start) - Vec3(linkage.ground, 0.0, 0.0);
  const double drawn = kPi - std::atan2(pin.y(), pin.x());  // between ground and rocker
  const auto stop = [&](double distance) {
    return std::acos(
        (linkage.rocker * linkage.rocker + linkage.ground * linkage.ground - distance * distance) /
        (2.0 * linkage.rocker * linkage.ground));
  };
  // Clockwise, the pin goes away from the crank's pivot.
  for (const double sense : {1.0, -1.0}) {
    const double distance = linkage.coupler - sense * linkage.crank;
    const MotionSolution solution =
        solve_motion(subject.network,
                     {.drives = {{.freedom = subject.network.driven_freedoms.at(0),
                                  .from = 0.0,
                                  .to = sense * 2.0 * kPi}},
                      .steps = 7,
                      .until_limit = true});

    ASSERT_EQ(solution.status, MotionStatus::limit);
    ASSERT_EQ(solution.position_count(), 8);
    EXPECT_NEAR(solution.drives.at(0).to, drawn - stop(distance), 1e-12);
    for (int k = 0; k <= 7; ++k) {
      EXPECT_EQ(solution.shares.at(static_cast<std::size_t>(k)), k / 7.0);
      EXPECT_NEAR(subject.position(solution.configuration_at(k), "d.wz"),
                  (drawn - stop(distance)) * k / 7.0,
                  1e-12);
    }
    ASSERT_FALSE(solution.special.empty());
    EXPECT_EQ(solution.special.back().kind, SpecialKind::limit);
    EXPECT_EQ(solution.special.back().share, 1.0);
  }
}

TEST(FourBar, CrankThatTurnsFullyComesToNoLimit) {
  const FourBar linkage;
  const Moving subject = moving(linkage.text(0.7), {"a.wz"});

  const MotionSolution solution = solve_motion(
      subject.network,
      {.drives = {{.freedom = subject.network.driven_freedoms.at(0), .from = 0.0, .to = 2.0 * kPi}},
       .steps = 9,
       .until_limit = true});

  EXPECT_EQ(solution.status, MotionStatus::completed);
  EXPECT_EQ(solution.drives.at(0).to, 2.0 * kPi);
  EXPECT_EQ(solution.position_count(), 10);
}

// 0.001 + t³ - 0.3 t² (1 - t)² is zero at two places between ends that are positive; the cubic of
// the ends is 0.001 + t³, and off it by 0.3/16 at most.
TEST(HermiteCubic, DoubtsARateThatHardlyLeavesZeroAtAnEnd) {
  const auto rate = [](double t) {
    return 0.001 + t * t * t - 0.3 * t * t * (1.0 - t) * (1.0 - t);
  };
  ASSERT_LT(rate(0.15), 0.0);
  const HermiteCubic from_low{.low = 0.001, .high = 1.001, .low_slope = 0.0, .high_slope = 3.0};
  const HermiteCubic from_high{.low = -1.001, .high = -0.001, .low_slope = 3.0, .high_slope = 0.0};
  for (const HermiteCubic& ends : {from_low, from_high}) {
    EXPECT_TRUE(ends.doubtful_part(0.3 / 16.0).has_value());
    EXPECT_FALSE(ends.doubtful_part(1e-5).has_value());
  }
}

}  // namespace
}  // namespace kinestat
