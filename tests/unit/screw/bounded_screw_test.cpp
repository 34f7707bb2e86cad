#include "screw/bounded_screw.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

constexpr double kSolved = 1e-15;  // relative error of the magnitudes below
constexpr int kDraws = 2000;

class Lines {
 public:
  Vec3 point() { return {uniform(), uniform(), uniform()}; }

  Vec3 direction() { return point().normalized(); }

  double magnitude() { return std::ldexp(uniform(), exponent_(generator_)); }

 private:
  double uniform() { return uniform_(generator_); }

  std::mt19937 generator_{20261123};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
  std::uniform_int_distribution<int> exponent_{-30, 30};
};

BoundedNumber solved(double magnitude) {
  return {.value = magnitude, .bound = kSolved * std::abs(magnitude)};
}

TEST(BoundedScrew, LeavesThePointsOfAnAxisAtRest) {
  Lines lines;
  for (int i = 0; i < kDraws; ++i) {
    const Vec3 at = lines.point();
    const Twist unit = unit_rotation(lines.direction(), at);
    const BoundedTwist twist = bounded_screw(solved(lines.magnitude()), unit, at);

    EXPECT_TRUE(velocity_at(twist, at).zeroed().isZero(0.0));
  }
}

// At an arm of 1e-12 the velocity is 4500 roundings of the terms whose difference it is.
TEST(BoundedScrew, KeepsTheVelocityOfAPointNextToTheAxis) {
  const double arm = 1e-12;
  const BoundedTwist twist =
      bounded_screw(solved(1.0), unit_rotation(Vec3::UnitZ(), {1.0, 1.0, 0.0}), {1.0, 1.0, 0.0});

  const Vec3 velocity = velocity_at(twist, {1.0 + arm, 1.0, 0.0}).zeroed();

  EXPECT_EQ(velocity.x(), 0.0);
  EXPECT_NEAR(velocity.y(), arm, 1e-3 * arm);
}

TEST(BoundedScrew, KeepsASmallComponentThatIsNoDifference) {
  const BoundedTwist twist = bounded_screw(
      {.value = 1e-200, .bound = 1e-215}, unit_rotation(Vec3::UnitZ(), Vec3(0, 0, 0)), {0, 0, 0});

  EXPECT_EQ(twist.zeroed().angular.z(), 1e-200);
}

TEST(BoundedScrew, OfARevoluteHasNoPowerOnWhatItBears) {
  Lines lines;
  for (int i = 0; i < kDraws; ++i) {
    const Vec3 at = lines.point();
    const Twist unit = unit_rotation(lines.direction(), at);
    const BoundedTwist twist = bounded_screw(solved(lines.magnitude()), unit, at);
    const BoundedWrench wrench =
        bounded_screw(solved(lines.magnitude()), unit_force(lines.direction(), at), at) +
        bounded_screw(solved(lines.magnitude()), unit_force(lines.direction(), at), at);

    EXPECT_EQ(power(wrench, twist).zeroed(), 0.0);
  }
}

TEST(BoundedScrew, HasThePowerOfACoupleOnARotation) {
  const BoundedTwist twist =
      bounded_screw(solved(3.0), unit_rotation(Vec3::UnitZ(), {1.0, 2.0, 0.0}), {1.0, 2.0, 0.0});
  const BoundedWrench wrench =
      bounded_screw(solved(-2.0), unit_couple(Vec3::UnitZ()), {1.0, 2.0, 0.0});

  const BoundedNumber found = power(wrench, twist);

  EXPECT_EQ(found.value, -6.0);
  EXPECT_LE(found.bound, 1e-13);
}

// The bound of a moment holds what the magnitude, the drawing and the sums may have changed: truth
// is taken from numbers at an end of their bounds, in numbers of 64 bits of mantissa.
TEST(BoundedScrew, HoldsTheMomentOfAForceThatIsOffByItsBound) {
  Lines lines;
  for (int i = 0; i < kDraws; ++i) {
    const Vec3 at = lines.point();
    const Vec3 about = lines.point();
    const Vec3 along = lines.direction();
    const double magnitude = lines.magnitude();
    const BoundedVector moment =
        moment_at(bounded_screw(solved(magnitude), unit_force(along, at), at), about);
    using Wide = Eigen::Matrix<long double, 3, 1>;
    const Wide arm = at.cast<long double>() - about.cast<long double>();
    const Wide force = (1.0L + kSolved) * magnitude * along.cast<long double>();
    const Wide truth = arm.cross(force);
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(std::abs(static_cast<double>(truth[k] - moment.value[k])), moment.bound[k]);
    }
  }
}

TEST(BoundedScrew, HasNoAxisWhereNothingIsMoreThanItsBound) {
  BoundedTwist twist;
  twist.angular = {.value = Vec3(1e-17, 0, 0), .bound = Vec3::Constant(1e-16)};

  EXPECT_FALSE(find_axis(twist, 1.0));
}

// A line that is one and a half times its bound: the square may be nothing, and the place anywhere.
TEST(BoundedScrew, HasNoAxisWhereNeitherPlaceNorPitchIsKnown) {
  BoundedTwist twist;
  twist.angular = {.value = Vec3(1.5e-9, 0, 0), .bound = Vec3(1e-9, 0, 0)};
  twist.linear = {.value = Vec3(0, 1e-9, 0), .bound = Vec3::Zero()};

  EXPECT_FALSE(find_axis(twist, 1.0));
}

TEST(BoundedScrew, WhoseRotationIsRoundingIsATranslation) {
  BoundedTwist twist;
  twist.angular = {.value = Vec3(1e-10, 0, 0), .bound = Vec3::Constant(1e-9)};
  twist.linear = {.value = Vec3(0, 2.0, 0), .bound = Vec3::Constant(1e-9)};

  const auto axis = find_axis(twist, 1.0);

  ASSERT_TRUE(axis);
  EXPECT_EQ(axis->direction, Vec3(0, 1, 0));
  EXPECT_FALSE(axis->pitch);
}

TEST(BoundedScrew, OfARotationHasNoPitch) {
  Lines lines;
  for (int i = 0; i < kDraws; ++i) {
    const Vec3 at = lines.point();
    const Twist unit = unit_rotation(lines.direction(), at);

    EXPECT_EQ(find_axis(bounded_screw(solved(lines.magnitude()), unit, at), 1.0)->pitch, 0.0);
  }
}

}  // namespace
}  // namespace kinestat
