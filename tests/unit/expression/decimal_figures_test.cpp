#include "expression/decimal_figures.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(RoundToFigures, GivesTheDoubleOfTheDecimalNumber) {
  EXPECT_EQ(round_to_figures(29.999999999999996, 15), 30.0);
  EXPECT_EQ(round_to_figures(-59.99999999999999, 15), -60.0);
  EXPECT_EQ(round_to_figures(0.30000000000000004, 15), 0.3);
  EXPECT_EQ(round_to_figures(123456.789, 3), 123000.0);
  EXPECT_EQ(round_to_figures(9.96e19, 2), 1e20);
  EXPECT_EQ(round_to_figures(1.26e-8, 2), 1.3e-8);
}

TEST(RoundToFigures, LeavesWhatIsZeroOrNotFinite) {
  EXPECT_EQ(round_to_figures(0.0, 15), 0.0);
  EXPECT_EQ(round_to_figures(-std::numeric_limits<double>::infinity(), 15),
            -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(round_to_figures(std::nan(""), 15)));
}

// Where ten to the needed power is no double.
TEST(RoundToFigures, LeavesWhatIsTooSmallOrTooLarge) {
  EXPECT_EQ(round_to_figures(1.0 / 3e9, 15), 1.0 / 3e9);
  EXPECT_EQ(round_to_figures(1e22 / 3.0, 2), 1e22 / 3.0);
  EXPECT_EQ(round_to_figures(std::numeric_limits<double>::denorm_min(), 15),
            std::numeric_limits<double>::denorm_min());
}

}  // namespace
}  // namespace kinestat
