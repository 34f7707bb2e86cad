#include "core/exact_text.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace kinestat {
namespace {

std::string exact_text(double value) {
  std::string text;
  append_exact(value, text);
  return text;
}

/// As {fmt} writes it, whose shortest decimals are another implementation.
std::string expected_text(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) {
    text += ".0";
  }
  return text;
}

TEST(ExactText, IsTheShortestThatIsReadAsTheSameNumber) {
  EXPECT_EQ(exact_text(0.1), "0.1");
  EXPECT_EQ(exact_text(-1.0 / 3.0), "-0.3333333333333333");
  EXPECT_EQ(exact_text(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(exact_text(5e-324), "5e-324");
  EXPECT_EQ(exact_text(-std::numeric_limits<double>::min()), "-2.2250738585072014e-308");
  EXPECT_EQ(exact_text(std::numeric_limits<double>::max()), "1.7976931348623157e+308");
}

TEST(ExactText, SaysThatWholeNumbersAreNotIntegers) {
  EXPECT_EQ(exact_text(0.0), "0.0");
  EXPECT_EQ(exact_text(-0.0), "0.0");
  EXPECT_EQ(exact_text(1.0), "1.0");
  EXPECT_EQ(exact_text(-1200.0), "-1200.0");
}

TEST(ExactText, HasAnExponentOnlyWhereThePointIsFarAway) {
  EXPECT_EQ(exact_text(1e15), "1000000000000000.0");
  EXPECT_EQ(exact_text(1e16), "1e+16");
  EXPECT_EQ(exact_text(12345678901234567.0), "1.2345678901234568e+16");
  EXPECT_EQ(exact_text(1e-4), "0.0001");
  EXPECT_EQ(exact_text(1.5e-4), "0.00015");
  EXPECT_EQ(exact_text(1e-5), "1e-05");
  EXPECT_EQ(exact_text(-2.5e-100), "-2.5e-100");
}

TEST(ExactText, OfRandomNumbersIsThatOfAnotherImplementation) {
  std::mt19937_64 random(1);
  const auto expect_same = [](double value) {
    const std::string text = exact_text(value);
    ASSERT_LE(text.size(), kLongestExact);
    ASSERT_EQ(text, expected_text(value));
  };
  for (int i = 0; i < 100'000; ++i) {
    const double any = std::bit_cast<double>(random());
    if (std::isfinite(any) && any != 0.0) {
      expect_same(any);
    }
    // Of few digits, and of a size that is written without an exponent.
    const auto few =
        static_cast<double>(random() >> (random() % 63)) / std::pow(10.0, random() % 20);
    expect_same(few + 1e-300);
    expect_same(std::ldexp(static_cast<double>(random()), -static_cast<int>(random() % 80)) +
                1e-300);
  }
}

}  // namespace
}  // namespace kinestat
