#include "screw/wrench.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(Wrench, OfAForceHasTheMomentOfItsLine) {
  // Along x through (2, 3, 5): T_O = p x F = (0, 5, -3).
  const Wrench wrench = unit_force(Vec3::UnitX(), {2.0, 3.0, 5.0});

  EXPECT_EQ(wrench.moment, Vec3(0.0, 5.0, -3.0));
  EXPECT_EQ(wrench.force, Vec3(1.0, 0.0, 0.0));
}

TEST(Wrench, HasNoMomentAboutAPointOfItsLine) {
  const Wrench wrench = unit_force(Vec3::UnitX(), {2.0, 3.0, 5.0});

  EXPECT_EQ(moment_at(wrench, {-4.0, 3.0, 5.0}), Vec3(0.0, 0.0, 0.0));
}

TEST(Wrench, OfACoupleHasTheSameMomentEverywhere) {
  EXPECT_EQ(moment_at(unit_couple(Vec3::UnitY()), {2.0, 3.0, 5.0}), Vec3(0.0, 1.0, 0.0));
}

TEST(Wrench, HasCoordinatesWithTheMomentFirst) {
  const Wrench wrench{.moment = {1.0, 2.0, 3.0}, .force = {4.0, 5.0, 6.0}};

  EXPECT_EQ(wrench.coordinates(), (Vec6() << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0).finished());
}

TEST(Power, OfACoupleOnARotationIsTorqueTimesSpeed) {
  EXPECT_EQ(
      power(3.0 * unit_couple(Vec3::UnitZ()), 2.0 * unit_rotation(Vec3::UnitZ(), {1.0, 4.0, 0.0})),
      6.0);
}

TEST(Power, OfAForceOnARotationIsItsArmTimesSpeed) {
  // A force along y at x = 4 has the arm 3 about the axis at x = 1.
  EXPECT_EQ(power(unit_force(Vec3::UnitY(), {4.0, 0.0, 0.0}),
                  2.0 * unit_rotation(Vec3::UnitZ(), {1.0, 0.0, 0.0})),
            6.0);
}

TEST(Power, OfAForceOnATranslationIsForceTimesSpeed) {
  EXPECT_EQ(
      power(unit_force(Vec3::UnitY(), {4.0, 0.0, 0.0}), 5.0 * unit_translation(Vec3::UnitY())),
      5.0);
}

TEST(Power, OfAForceThroughTheAxisOfARotationIsZero) {
  EXPECT_EQ(power(unit_force(Vec3::UnitX(), {1.0, 2.0, 9.0}),
                  unit_rotation(Vec3::UnitZ(), {7.0, 2.0, 0.0})),
            0.0);
}

TEST(Power, OfACoupleOnATranslationIsZero) {
  EXPECT_EQ(power(unit_couple(Vec3::UnitX()), unit_translation(Vec3::UnitX())), 0.0);
}

TEST(UnitForce, ThroughTheOriginHasNoMomentHoweverItsPointWasComputed) {
  const Vec3 direction = Vec3(0.1, -0.7, 0.3).normalized();

  EXPECT_EQ(unit_force(direction, direction * 0.3).moment, Vec3::Zero());
  EXPECT_NE(unit_force(direction, direction * 0.3 + Vec3(1e-12, 0.0, 0.0)).moment, Vec3::Zero());
}

}  // namespace
}  // namespace kinestat
