#include "math/dense/polynomial.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// (x - 1)(x - 2)(x + 3)(x - 0.5) = x⁴ - 0.5 x³ - 7 x² + 9.5 x - 3
TEST(Polynomial, ChangesItsSignAtItsRoots) {
  const auto roots = find_sign_changes({-3.0, 9.5, -7.0, -0.5, 1.0}, -10.0, 10.0);

  ASSERT_EQ(roots.size(), 4U);
  EXPECT_NEAR(roots[0], -3.0, 1e-14);
  EXPECT_NEAR(roots[1], 0.5, 1e-14);
  EXPECT_NEAR(roots[2], 1.0, 1e-14);
  EXPECT_NEAR(roots[3], 2.0, 1e-14);
}

TEST(Polynomial, IsLookedAtInTheIntervalOnly) {
  EXPECT_EQ(find_sign_changes({-3.0, 9.5, -7.0, -0.5, 1.0}, 0.0, 0.75).size(), 1U);
}

TEST(Polynomial, WithoutRealRootsChangesNowhere) {
  EXPECT_TRUE(find_sign_changes({1.0, 0.0, 1.0}, -5.0, 5.0).empty());
}

TEST(Polynomial, MayHaveALeadingZero) {
  EXPECT_EQ(find_sign_changes({-1.0, 2.0, 0.0, 0.0}, -5.0, 5.0).size(), 1U);
}

}  // namespace
}  // namespace kinestat
