#include "report/number_format.hpp"

#include <cstdlib>
#include <limits>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "core/contract.hpp"

namespace kinestat {
namespace {

using Limits = std::numeric_limits<double>;

struct Written {
  const char* name;
  double value;
  const char* text;
};

class FormatExact : public testing::TestWithParam<Written> {};

TEST_P(FormatExact, IsTheShortestTextThatReadsBack) {
  EXPECT_EQ(format_exact(GetParam().value), GetParam().text);
  EXPECT_EQ(std::strtod(GetParam().text, nullptr), GetParam().value);
}

INSTANTIATE_TEST_SUITE_P(
    Numbers,
    FormatExact,
    testing::Values(
        Written{"Whole", 100.0, "100.0"},
        Written{"Negative", -7.0, "-7.0"},
        Written{"Tenth", 0.1, "0.1"},
        Written{"SumOfTenths", 0.1 + 0.2, "0.30000000000000004"},
        Written{"Fraction", 27.0 / 13.0, "2.076923076923077"},
        Written{"Small", 1e-7, "1e-07"},
        Written{"Large", 1e22, "1e+22"},
        Written{"Largest", Limits::max(), "1.7976931348623157e+308"},
        Written{"Longest", -2.2250738585072014e-308, "-2.2250738585072014e-308"},
        Written{"LongestWithoutExponent", -0.00012345678901234567, "-0.00012345678901234567"},
        Written{"LargestWithoutExponent", -1234567890123456.0, "-1234567890123456.0"},
        Written{"BeyondIt", 1e16, "1e+16"},
        Written{"Smallest", Limits::denorm_min(), "5e-324"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(FormatExactOfZero, HasNoSign) {
  EXPECT_EQ(format_exact(0.0), "0.0");
  EXPECT_EQ(format_exact(-0.0), "0.0");
}

TEST(FormatExactOfNoNumber, IsRefused) {
  EXPECT_THROW(std::ignore = format_exact(Limits::quiet_NaN()), ContractViolation);
  EXPECT_THROW(std::ignore = format_exact(Limits::infinity()), ContractViolation);
}

TEST(FormatShort, HasSixSignificantDigits) {
  EXPECT_EQ(format_short(595.0 / 209.0), "2.84689");
  EXPECT_EQ(format_short(-1234567.0), "-1.23457e+06");
}

TEST(FormatShort, LeavesOutTrailingZeros) {
  EXPECT_EQ(format_short(100.0), "100");
  EXPECT_EQ(format_short(2.5), "2.5");
}

TEST(FormatShort, WritesBothZerosAlike) {
  EXPECT_EQ(format_short(0.0), "0");
  EXPECT_EQ(format_short(-0.0), "0");
}

TEST(FormatShort, RefusesWhatIsNoNumber) {
  EXPECT_THROW(std::ignore = format_short(Limits::quiet_NaN()), ContractViolation);
}

}  // namespace
}  // namespace kinestat
