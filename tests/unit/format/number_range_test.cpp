#include "description/number_range.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(NumberRange, HoldsItsClosedBoundsAndNotItsOpenOnes) {
  EXPECT_TRUE(kLostShare.holds(0.0));
  EXPECT_FALSE(kLostShare.holds(1.0));
  EXPECT_FALSE(kKeptShare.holds(0.0));
  EXPECT_TRUE(kKeptShare.holds(1.0));
  EXPECT_FALSE(kBelowRightAngle.holds(-std::numbers::pi / 2));
  EXPECT_TRUE(kBelowRightAngle.holds(std::nextafter(-std::numbers::pi / 2, 0.0)));
}

TEST(NumberRange, TakesForWholeWhatRoundingLeavesOfAWholeNumber) {
  EXPECT_TRUE(kTeeth.holds(0.1 * 30.0));  // 3.0000000000000004
  EXPECT_FALSE(kTeeth.holds(3.0001));
  EXPECT_FALSE(kTeeth.holds(10'001.0));
}

TEST(NumberRange, RefusesZeroAloneWhereOnlyZeroIsRefused) {
  EXPECT_FALSE(kNotZero.holds(0.0));
  EXPECT_FALSE(kNotZero.holds(-0.0));
  EXPECT_TRUE(kNotZero.holds(-1e-300));
}

TEST(NumberRange, HoldsNothingThatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(kNotNegative.holds(nan));
  EXPECT_FALSE(kTeeth.holds(nan));
}

TEST(NumberRange, KeepsOfUnknownUnitsOnlyWhereZeroLies) {
  const NumberRange acute = in_any_unit(kAcuteAngle);

  EXPECT_EQ(acute.least, 0.0);
  EXPECT_FALSE(acute.below);
}

}  // namespace
}  // namespace kinestat
