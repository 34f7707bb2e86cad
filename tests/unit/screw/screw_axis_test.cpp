#include "screw/screw_axis.hpp"

#include <gtest/gtest.h>

#include "support/near.hpp"

namespace kinestat {
namespace {

TEST(ScrewAxis, OfAPureRotationHasPitchZeroAndThePointNextToTheOrigin) {
  const auto axis = find_axis(2.0 * unit_rotation(Vec3::UnitZ(), {3.0, 4.0, 9.0}), 1.0);

  ASSERT_TRUE(axis && axis->point && axis->pitch);
  EXPECT_TRUE(is_near(axis->direction, Vec3(0.0, 0.0, 1.0), kTight));
  EXPECT_TRUE(is_near(*axis->point, Vec3(3.0, 4.0, 0.0), kTight));
  EXPECT_NEAR(*axis->pitch, 0.0, kTight);
}

TEST(ScrewAxis, OfATranslationHasNeitherPointNorPitch) {
  const auto axis = find_axis(-3.0 * unit_translation(Vec3::UnitX()), 1.0);

  ASSERT_TRUE(axis);
  EXPECT_TRUE(is_near(axis->direction, Vec3(-1.0, 0.0, 0.0), kTight));
  EXPECT_FALSE(axis->point);
  EXPECT_FALSE(axis->pitch);
}

TEST(ScrewAxis, OfAGeneralMotionHasItsPitch) {
  // 2 rad/s about z through (1, 0, 0) with 6 m/s along it: 3 m/rad.
  const Twist twist =
      2.0 * unit_rotation(Vec3::UnitZ(), {1.0, 0.0, 0.0}) + 6.0 * unit_translation(Vec3::UnitZ());

  const auto axis = find_axis(twist, 1.0);

  ASSERT_TRUE(axis && axis->point && axis->pitch);
  EXPECT_TRUE(is_near(*axis->point, Vec3(1.0, 0.0, 0.0), kTight));
  EXPECT_NEAR(*axis->pitch, 3.0, kTight);
}

TEST(ScrewAxis, OfRestIsEmpty) {
  EXPECT_FALSE(find_axis(Twist{}, 1.0));
}

TEST(ScrewAxis, OfARotationThatIsRoundingIsATranslation) {
  const Twist twist{.angular = {0.0, 0.0, 1e-15}, .linear = {1.0, 0.0, 0.0}};

  const auto axis = find_axis(twist, 1.0);

  ASSERT_TRUE(axis);
  EXPECT_FALSE(axis->pitch);
}

TEST(ScrewAxis, OfAForceIsItsLine) {
  const auto axis = find_axis(5.0 * unit_force(Vec3::UnitX(), {7.0, 2.0, 3.0}), 1.0);

  ASSERT_TRUE(axis && axis->point && axis->pitch);
  EXPECT_TRUE(is_near(axis->direction, Vec3(1.0, 0.0, 0.0), kTight));
  EXPECT_TRUE(is_near(*axis->point, Vec3(0.0, 2.0, 3.0), kTight));
  EXPECT_NEAR(*axis->pitch, 0.0, kTight);
}

TEST(ScrewAxis, OfACoupleHasInfinitePitch) {
  const auto axis = find_axis(unit_couple(Vec3::UnitY()), 1.0);

  ASSERT_TRUE(axis);
  EXPECT_FALSE(axis->point);
}

TEST(ScrewAxis, OfNoActionIsEmpty) {
  EXPECT_FALSE(find_axis(Wrench{}, 1.0));
}

}  // namespace
}  // namespace kinestat
