#include "studies/synthesis/positions/plane_area.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(PlaneArea, OfARectangleHasAnyTwoOppositeCorners) {
  for (const PlaneArea& area : {PlaneArea::between({-1.0, -2.0}, {3.0, 4.0}),
                                PlaneArea::between({3.0, -2.0}, {-1.0, 4.0})}) {
    EXPECT_EQ(area.distance({0.0, 0.0}), 0.0);
    EXPECT_EQ(area.distance({3.0, 4.0}), 0.0);
    EXPECT_DOUBLE_EQ(area.distance({5.0, 0.0}), 2.0);
    EXPECT_DOUBLE_EQ(area.distance({6.0, 8.0}), 5.0);
  }
}

// An angle whose notch is not within.
TEST(PlaneArea, MayHaveANotch) {
  const PlaneArea area({{0.0, 0.0}, {4.0, 0.0}, {4.0, 1.0}, {1.0, 1.0}, {1.0, 4.0}, {0.0, 4.0}});

  EXPECT_EQ(area.distance({0.5, 3.5}), 0.0);
  EXPECT_EQ(area.distance({3.5, 0.5}), 0.0);
  EXPECT_DOUBLE_EQ(area.distance({2.0, 3.0}), 1.0);
  EXPECT_DOUBLE_EQ(area.distance({3.0, 3.0}), 2.0);
  EXPECT_DOUBLE_EQ(area.distance({-3.0, -4.0}), 5.0);
}

TEST(PlaneArea, CountsItsRimWhateverRoundingSays) {
  const PlaneArea area({{0.1, 0.1}, {0.7, 0.3}, {0.2, 0.9}});

  for (int i = 0; i <= 10; ++i) {
    EXPECT_EQ(area.distance({0.1 + 0.06 * i, 0.1 + 0.02 * i}), 0.0) << i;
  }
}

}  // namespace
}  // namespace kinestat
