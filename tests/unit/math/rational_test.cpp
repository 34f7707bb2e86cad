#include "math/numbers/rational.hpp"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

struct DecimalCase {
  const char* name;
  const char* literal;
  const char* fraction;
};

class Decimals : public testing::TestWithParam<DecimalCase> {};

TEST_P(Decimals, AreReadDigitByDigit) {
  EXPECT_EQ(read_decimal(GetParam().literal), Rational(GetParam().fraction));
}

INSTANTIATE_TEST_SUITE_P(Table,
                         Decimals,
                         testing::Values(DecimalCase{"whole", "24", "24"},
                                         DecimalCase{"tenth", "0.1", "1/10"},
                                         DecimalCase{"lowest_terms", "0.50", "1/2"},
                                         DecimalCase{"point_first", ".25", "1/4"},
                                         DecimalCase{"point_last", "3.", "3"},
                                         DecimalCase{"negative", "-1.5", "-3/2"},
                                         DecimalCase{"plus", "+2", "2"},
                                         DecimalCase{"exponent", "1e-3", "1/1000"},
                                         DecimalCase{"capital_exponent", "2.5E+3", "2500"},
                                         DecimalCase{"exponent_with_zeros", "1e0000002", "100"},
                                         DecimalCase{"zero", "0.000", "0"},
                                         DecimalCase{"zero_with_huge_exponent", "0e999999999", "0"},
                                         DecimalCase{"more_digits_than_a_double",
                                                     "0.12345678901234567890123",
                                                     "12345678901234567890123/"
                                                     "100000000000000000000000"}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Rational, SmallestDoubleIsReadExactly) {
  EXPECT_EQ(*read_decimal("5e-324") * *read_decimal("2e323"), 1);
}

TEST(Rational, HugeExponentHasNoValue) {
  EXPECT_FALSE(read_decimal("1e999999999").has_value());
  EXPECT_FALSE(read_decimal("1e-999999999").has_value());
  EXPECT_FALSE(read_decimal("1e99999999999999999999999").has_value());
}

TEST(Rational, ThousandsOfDigitsHaveNoValue) {
  EXPECT_FALSE(read_decimal("0." + std::string(4000, '7')).has_value());
}

struct NearestCase {
  const char* name;
  Rational value;
  double nearest;
};

class NearestDoubles : public testing::TestWithParam<NearestCase> {};

TEST_P(NearestDoubles, AreRoundedToEven) {
  EXPECT_EQ(to_double(GetParam().value), GetParam().nearest);
}

// 2^53 + 1 lies midway between two doubles, and 2^53 has the even last digit; so has 2^53 + 4
// beside 2^53 + 3.
INSTANTIATE_TEST_SUITE_P(
    Table,
    NearestDoubles,
    testing::Values(NearestCase{"zero", Rational(0), 0.0},
                    NearestCase{"tenth", Rational(1, 10), 0.1},
                    NearestCase{"two_thirds", Rational(2, 3), 2.0 / 3.0},
                    NearestCase{"negative", Rational(-2, 3), -2.0 / 3.0},
                    NearestCase{"tie_inwards", Rational("9007199254740993"), 9007199254740992.0},
                    NearestCase{"tie_outwards", Rational("9007199254740995"), 9007199254740996.0},
                    NearestCase{
                        "above_a_tie", Rational("90071992547409931/10"), 9007199254740994.0},
                    NearestCase{"subnormal", *read_decimal("5e-324"), 5e-324}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(Rational, RoundsDownTowardsMinusInfinity) {
  EXPECT_EQ(rounded_down(Rational(7, 2)), 3);
  EXPECT_EQ(rounded_down(Rational(-7, 2)), -4);
  EXPECT_EQ(rounded_down(Rational(-4)), -4);
}

TEST(Rational, WholePowersAreExact) {
  EXPECT_EQ(whole_power(Rational(2, 3), Rational(3)), Rational(8, 27));
  EXPECT_EQ(whole_power(Rational(2, 3), Rational(-2)), Rational(9, 4));
  EXPECT_EQ(whole_power(Rational(-2), Rational(3)), Rational(-8));
  EXPECT_EQ(whole_power(Rational(5), Rational(0)), Rational(1));
  EXPECT_EQ(whole_power(Rational(0), Rational(7)), Rational(0));
}

TEST(Rational, UnitsTakeAnyWholePower) {
  EXPECT_EQ(whole_power(Rational(1), *read_decimal("1e300")), Rational(1));
  EXPECT_EQ(whole_power(Rational(-1), *read_decimal("1e300")), Rational(1));
  EXPECT_EQ(whole_power(Rational(-1), *read_decimal("-3")), Rational(-1));
}

TEST(Rational, OtherPowersHaveNoExactValue) {
  EXPECT_FALSE(whole_power(Rational(4), Rational(1, 2)).has_value());
  EXPECT_FALSE(whole_power(Rational(0), Rational(-1)).has_value());
}

TEST(Rational, PowersBeyondTheLimitHaveNoValue) {
  EXPECT_TRUE(whole_power(Rational(2), Rational(4095)).has_value());
  EXPECT_FALSE(whole_power(Rational(2), Rational(4096)).has_value());
  EXPECT_FALSE(whole_power(Rational(3, 2), *read_decimal("1e300")).has_value());
}

TEST(Rational, RootOfASquareIsExact) {
  EXPECT_EQ(exact_square_root(Rational(9, 4)), Rational(3, 2));
  EXPECT_EQ(exact_square_root(Rational(0)), Rational(0));
}

TEST(Rational, OtherRootsHaveNoExactValue) {
  EXPECT_FALSE(exact_square_root(Rational(2)).has_value());
  EXPECT_FALSE(exact_square_root(Rational(1, 2)).has_value());
  EXPECT_FALSE(exact_square_root(Rational(-4)).has_value());
}

TEST(Rational, CommonDivisorIsNotNegative) {
  EXPECT_EQ(common_divisor(Rational(-12), Rational(18)), 6);
  EXPECT_EQ(common_divisor(Rational(0), Rational(-5)), 5);
  EXPECT_EQ(common_divisor(Rational(0), Rational(0)), 0);
}

}  // namespace
}  // namespace kinestat
