#include "report/json_values.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(JsonNumber, KeepsThePointOfAWholeDouble) {
  EXPECT_EQ(number(2.0).dump(), "2.0");
}

TEST(JsonNumber, WritesMinusZeroAsZero) {
  EXPECT_EQ(number(-0.0).dump(), "0.0");
}

TEST(JsonNumber, IsNullForWhatIsNotFinite) {
  EXPECT_TRUE(number(std::numeric_limits<double>::quiet_NaN()).is_null());
  EXPECT_TRUE(number(std::numeric_limits<double>::infinity()).is_null());
}

TEST(JsonNumber, IsNullWithoutAValue) {
  EXPECT_TRUE(number(std::optional<double>()).is_null());
}

}  // namespace
}  // namespace kinestat
