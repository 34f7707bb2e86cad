#include "draw/labels.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

constexpr PixelBox kArea = {.left = 0.0, .top = 0.0, .right = 300.0, .bottom = 200.0};

TEST(Labels, StandBesideTheirPoint) {
  PointLabels placer(kArea);
  Svg svg;

  ASSERT_TRUE(placer.write({.x = 150.0, .y = 100.0}, "max", {}, svg));

  EXPECT_LT(svg.bounds().left, 170.0);
  EXPECT_FALSE(
      svg.bounds().overlaps({.left = 149.0, .top = 99.0, .right = 151.0, .bottom = 101.0}));
}

TEST(Labels, DoNotCoverEachOther) {
  PointLabels placer(kArea);
  std::vector<PixelBox> boxes;
  for (int i = 0; i < 8; ++i) {
    Svg svg;
    ASSERT_TRUE(placer.write({.x = 150.0 + i, .y = 100.0}, "dead point", {}, svg));
    for (const PixelBox& other : boxes) {
      // Lines that lead to a label may cross; texts alone are compared.
      EXPECT_FALSE(svg.bounds().grown(-4.0).overlaps(other.grown(-4.0)) &&
                   svg.elements().find("<line") == std::string::npos);
    }
    boxes.push_back(svg.bounds());
  }
}

TEST(Labels, StayWithinTheArea) {
  PointLabels placer(kArea);
  Svg svg;

  ASSERT_TRUE(placer.write({.x = 299.0, .y = 1.0}, "at the corner", {}, svg));

  EXPECT_LE(svg.bounds().right, kArea.right);
  EXPECT_GE(svg.bounds().top, kArea.top);
}

TEST(Labels, AreLeftOutWhereThereIsNoRoom) {
  PointLabels placer({.left = 0.0, .top = 0.0, .right = 20.0, .bottom = 20.0});
  Svg svg;

  EXPECT_FALSE(placer.write({.x = 10.0, .y = 10.0}, "far too long", {}, svg));
  EXPECT_TRUE(svg.elements().empty());
}

// The same line by its ends alone.
TEST(Labels, AvoidCurvesBetweenTheirPoints) {
  PointLabels placer(kArea);
  placer.avoid({{.x = 0.0, .y = 92.0}, {.x = 300.0, .y = 92.0}});
  Svg svg;

  ASSERT_TRUE(placer.write({.x = 150.0, .y = 100.0}, "below", {}, svg));

  EXPECT_GT(svg.bounds().top, 92.0);
}

TEST(Labels, AvoidCurves) {
  PointLabels placer(kArea);
  std::vector<PixelPoint> curve;
  for (int x = 0; x < 300; ++x) {
    curve.push_back({.x = static_cast<double>(x), .y = 92.0});
  }
  placer.avoid(curve);
  Svg svg;

  ASSERT_TRUE(placer.write({.x = 150.0, .y = 100.0}, "below", {}, svg));

  EXPECT_GT(svg.bounds().top, 92.0);
}

}  // namespace
}  // namespace kinestat
