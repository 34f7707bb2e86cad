#include "studies/synthesis/curves/plane_cubic.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// (u² + v²)(u + 2 v) - 3 u v = 0: a loop through the origin, which is a node.
const PlaneCubic kCrossing{.k = {1.0, 2.0}, .q = {0.0, -3.0, 0.0}, .l = {0.0, 0.0}, .c = 0.0};

TEST(PlaneCubic, HasItsFocusOnIt) {
  EXPECT_LT(kCrossing.miss(*kCrossing.focus()), 1e-15);
}

// In polar coordinates r = 3 sin cos / (cos + 2 sin); along e = (-2, 1)/√5 the quadratic terms are
// -3 (-2)(1)/5, so that the asymptote is (u + 2 v) = -6/5.
TEST(PlaneCubic, HasItsAsymptote) {
  const PlaneLine line = *kCrossing.asymptote();

  EXPECT_NEAR(line.offset, -1.2 / std::sqrt(5.0), 1e-15);
  EXPECT_NEAR(cross(line.normal, {1.0, 2.0}), 0.0, 1e-15);
}

TEST(PlaneCubic, MayBeWrittenAboutAnotherCentre) {
  const PlaneCubic moved = kCrossing.about({-1.5, 0.7}, 4.0);

  for (const double angle : {0.3, 1.1, 1.4}) {
    const double r =
        3.0 * std::sin(angle) * std::cos(angle) / (std::cos(angle) + 2.0 * std::sin(angle));
    EXPECT_LT(moved.miss(std::polar(r, angle)), 1e-15);
  }
  EXPECT_LT(std::abs(*moved.focus() - *kCrossing.focus()), 1e-15);
}

TEST(PlaneCubic, HasZeroCoefficientsWhereRoundingLeavesThem) {
  PlaneCubic small = kCrossing;
  small.l[1] = 1e-13;

  const PlaneCubic back = kCrossing.settled_about({-1.5, 0.7}, 4.0).settled_about({0.0, 0.0}, 1.0);

  EXPECT_EQ(back.q[0], 0.0);
  EXPECT_EQ(back.q[2], 0.0);
  EXPECT_EQ(back.l[0], 0.0);
  EXPECT_EQ(back.c, 0.0);
  EXPECT_DOUBLE_EQ(small.settled_about({0.0, 0.0}, 1.0).l[1], 1e-13 / 3.0);
}

}  // namespace
}  // namespace kinestat
