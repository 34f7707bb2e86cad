#include "studies/shift/internal/remaining_motion.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

RateRow row(std::initializer_list<double> values, double bound) {
  RateRow result;
  for (const double value : values) {
    result.push_back(value == 0.0 ? BoundedNumber{}
                                  : BoundedNumber{.value = value, .bound = bound});
  }
  return result;
}

// 1/3 and what is left of it after rounding: the second row is the first, three times as large.
TEST(RemainingMotion, TakesRoundingOfADependentRowForNothing) {
  const double third = 1.0 / 3.0;
  RemainingMotion left(2);
  ASSERT_TRUE(left.prescribe(row({third, 0.1}, 1e-16), 0.0));

  EXPECT_FALSE(left.prescribe(row({1.0, 0.3 + 4e-16}, 1e-15), 0.0));
  EXPECT_EQ(left.count(), 1);
}

// The difference is a thousand times what the rows may be off by: it counts, however small.
TEST(RemainingMotion, CountsASmallChangeThatItsBoundTellsFromZero) {
  RemainingMotion left(2);
  ASSERT_TRUE(left.prescribe(row({1.0, 1.0}, 1e-16), 0.0));

  EXPECT_TRUE(left.prescribe(row({1.0, 1.0 + 1e-12}, 1e-16), 0.0));
  EXPECT_EQ(left.count(), 0);
}

// What one row leaves of rounding is zero for all that come after it, even where nothing else is
// left to compare it with.
TEST(RemainingMotion, KeepsNoRoundingForLaterRows) {
  RemainingMotion left(3);
  ASSERT_TRUE(left.prescribe(row({0.1, 0.2, 0.0}, 1e-16), 0.0));
  ASSERT_TRUE(left.prescribe(row({0.3, 0.7, 0.0}, 1e-16), 0.0));

  EXPECT_FALSE(left.changes(row({0.9, 1.1, 0.0}, 1e-16)));
  EXPECT_TRUE(left.changes(row({0.0, 0.0, 1.0}, 1e-16)));
}

TEST(RemainingMotion, GivesTheRateOfWhatIsPrescribed) {
  RemainingMotion left(2);
  ASSERT_TRUE(left.prescribe(row({1.0, 2.0}, 1e-16), 5.0));
  ASSERT_TRUE(left.prescribe(row({1.0, -1.0}, 1e-16), -1.0));

  const BoundedNumber rate = left.rate(row({1.0, 1.0}, 1e-16));  // of 1 and 2
  EXPECT_NEAR(rate.value, 3.0, rate.bound);
  EXPECT_LT(rate.bound, 1e-13);
}

}  // namespace
}  // namespace kinestat
