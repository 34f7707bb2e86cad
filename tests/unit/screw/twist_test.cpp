#include "screw/twist.hpp"

#include <gtest/gtest.h>

#include "support/near.hpp"

namespace kinestat {
namespace {

TEST(Twist, OfARotationMovesTheOriginByTheMomentOfTheAxis) {
  // About z through (2, 3, 5): v_O = p x z = (3, -2, 0).
  const Twist twist = unit_rotation(Vec3::UnitZ(), {2.0, 3.0, 5.0});

  EXPECT_EQ(twist.angular, Vec3(0.0, 0.0, 1.0));
  EXPECT_EQ(twist.linear, Vec3(3.0, -2.0, 0.0));
}

TEST(Twist, LeavesThePointsOfItsRotationAxisAtRest) {
  const Twist twist = unit_rotation(Vec3::UnitZ(), {2.0, 3.0, 5.0});

  EXPECT_EQ(velocity_at(twist, {2.0, 3.0, -7.0}), Vec3(0.0, 0.0, 0.0));
}

TEST(Twist, MovesAPointByOmegaCrossTheArm) {
  const Twist twist = 2.0 * unit_rotation(Vec3::UnitZ(), {2.0, 3.0, 5.0});

  // 2 z x (1, 0, 0) = (0, 2, 0).
  EXPECT_EQ(velocity_at(twist, {3.0, 3.0, 5.0}), Vec3(0.0, 2.0, 0.0));
}

TEST(Twist, OfATranslationMovesEveryPointAlike) {
  EXPECT_EQ(velocity_at(unit_translation(Vec3::UnitX()), {7.0, 8.0, 9.0}), Vec3(1.0, 0.0, 0.0));
}

TEST(Twist, AddsAndSubtractsComponentwise) {
  const Twist a{.angular = {1.0, 2.0, 3.0}, .linear = {4.0, 5.0, 6.0}};
  const Twist b{.angular = {6.0, 5.0, 4.0}, .linear = {3.0, 2.0, 1.0}};

  EXPECT_EQ((a + b).coordinates(), Vec6(Vec6::Constant(7.0)));
  EXPECT_EQ(((a + b) - b).coordinates(), a.coordinates());
}

TEST(Twist, HasCoordinatesWithTheAngularPartFirst) {
  const Vec6 c = (Vec6() << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0).finished();

  EXPECT_EQ(Twist::from_coordinates(c).angular, Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(Twist::from_coordinates(c).coordinates(), c);
}

}  // namespace
}  // namespace kinestat
