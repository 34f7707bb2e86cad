#include "math/numbers/double_double.hpp"

#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "math/numbers/rational.hpp"
#include "support/random.hpp"
#include "unit/math/exact_value.hpp"

namespace kinestat {
namespace {

// What the type promises under the flags that the project is built with. A compiler that fuses
// products and sums, or reorders them, leaves 1e-16.
const Rational kPromise = *read_decimal("1e-30");

// Whether `actual` is `expected` to 1e-30 of it and its parts do not overlap.
::testing::AssertionResult is_right(DoubleDouble actual, const Rational& expected) {
  const Rational error = abs(Rational(exact(actual) - expected));
  if (error > kPromise * abs(expected)) {
    return ::testing::AssertionFailure() << fmt::format("{:a} + {:a} is off by {:.3g} of {:.17g}",
                                                        actual.high,
                                                        actual.low,
                                                        to_double(Rational(error / abs(expected))),
                                                        to_double(expected));
  }
  if (actual.high + actual.low != actual.high) {
    return ::testing::AssertionFailure()
           << fmt::format("{:a} and {:a} overlap", actual.high, actual.low);
  }
  return ::testing::AssertionSuccess();
}

/// Operands of one decade, or spread over many; those of a pair may nearly cancel.
class Operands {
 public:
  Operands(std::uint64_t seed, int largest_exponent)
      : random_(seed), largest_exponent_(largest_exponent) {}

  double number() {
    const int exponent = random_.whole(-largest_exponent_, largest_exponent_);
    const double mantissa = random_.chance(0.1) ? 1.0 : random_.magnitude();
    return std::ldexp(mantissa, exponent);
  }

  DoubleDouble pair() {
    const double high = number();
    const double share = random_.chance(0.1) ? 0.0 : random_.between(-0.5, 0.5);
    const double ulp = std::ldexp(1.0, std::ilogb(high) - 52);
    return quick_two_sum(high, share * ulp);
  }

  /// Differs from -a in its last few bits, or is any number.
  DoubleDouble partner_of(DoubleDouble a) {
    if (random_.chance(0.5)) {
      return pair();
    }
    const double far = std::ldexp(a.high, -random_.whole(40, 104));
    return quick_two_sum(-a.high, -a.low + far * random_.magnitude());
  }

 private:
  Random random_;
  int largest_exponent_;
};

struct Range {
  const char* name;
  std::uint64_t seed;
  int largest_exponent;
};

class DoubleDoubles : public ::testing::TestWithParam<Range> {
 protected:
  static constexpr int kTrials = 3000;
  Operands operands_{GetParam().seed, GetParam().largest_exponent};
};

// Products of two reach 2^±900, within the range in which two_product is exact.
INSTANTIATE_TEST_SUITE_P(Range,
                         DoubleDoubles,
                         ::testing::Values(Range{"about_one", 1, 2},
                                           Range{"many_decades", 2, 100},
                                           Range{"extreme", 3, 430}),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(DoubleDoubles, AreTheExactSumOfTwoDoubles) {
  for (int i = 0; i < kTrials; ++i) {
    const double a = operands_.number();
    const double b = operands_.number();

    ASSERT_EQ(exact(two_sum(a, b)), exact(a) + exact(b)) << fmt::format("{:a} {:a}", a, b);
  }
}

TEST_P(DoubleDoubles, AreTheExactQuickSumOfALargerAndASmallerDouble) {
  for (int i = 0; i < kTrials; ++i) {
    double a = operands_.number();
    double b = operands_.number();
    if (std::abs(a) < std::abs(b)) {
      std::swap(a, b);
    }

    ASSERT_EQ(exact(quick_two_sum(a, b)), exact(a) + exact(b)) << fmt::format("{:a} {:a}", a, b);
  }
}

TEST_P(DoubleDoubles, AreTheExactProductOfTwoDoubles) {
  for (int i = 0; i < kTrials; ++i) {
    const double a = operands_.number();
    const double b = operands_.number();

    ASSERT_EQ(exact(two_product(a, b)), exact(a) * exact(b)) << fmt::format("{:a} {:a}", a, b);
  }
}

TEST_P(DoubleDoubles, AddAlsoWhereTheyCancel) {
  for (int i = 0; i < kTrials; ++i) {
    const DoubleDouble a = operands_.pair();
    const DoubleDouble b = operands_.partner_of(a);

    ASSERT_TRUE(is_right(a + b, exact(a) + exact(b)));
    ASSERT_TRUE(is_right(a - b, exact(a) - exact(b)));
  }
}

TEST_P(DoubleDoubles, Multiply) {
  for (int i = 0; i < kTrials; ++i) {
    const DoubleDouble a = operands_.pair();
    const DoubleDouble b = operands_.pair();

    ASSERT_TRUE(is_right(a * b, exact(a) * exact(b)));
    ASSERT_TRUE(is_right(a * b.high, exact(a) * exact(b.high)));
  }
}

TEST_P(DoubleDoubles, Divide) {
  for (int i = 0; i < kTrials; ++i) {
    const DoubleDouble a = operands_.pair();
    const DoubleDouble b = operands_.pair();

    ASSERT_TRUE(is_right(a / b, exact(a) / exact(b)));
  }
}

// A root that is right to a share e has a square that is right to 2 e.
TEST_P(DoubleDoubles, HaveSquareRoots) {
  for (int i = 0; i < kTrials; ++i) {
    const DoubleDouble pair = operands_.pair();
    const DoubleDouble a = pair.high < 0.0 ? -pair : pair;
    const Rational root = exact(sqrt(a));

    ASSERT_LE(abs(Rational(root * root - exact(a))), 2 * kPromise * exact(a));
  }
}

TEST(DoubleDouble, KeepsWhatADoubleLoses) {
  const DoubleDouble sum = two_sum(1.0, 0x1p-80);

  EXPECT_EQ(sum, (DoubleDouble{.high = 1.0, .low = 0x1p-80}));
  EXPECT_EQ((sum - DoubleDouble{.high = 1.0, .low = 0.0}).high, 0x1p-80);
}

// Where they end: the largest operand that can be halved, and the smallest product whose last bit
// is still a double.
TEST(DoubleDouble, MultipliesExactlyUpToTheEndsOfItsRange) {
  const double largest = std::nextafter(0x1p996, 0.0);
  const double least = std::nextafter(0x1p-484, 1.0);

  EXPECT_EQ(exact(two_product(largest, 3.0)), exact(largest) * 3);
  EXPECT_EQ(exact(two_product(least, least)), exact(least) * exact(least));
}

TEST(DoubleDouble, AddsSubnormalNumbersExactly) {
  const double least = std::numeric_limits<double>::denorm_min();

  EXPECT_EQ(two_sum(1.0, least), (DoubleDouble{.high = 1.0, .low = least}));
}

TEST(DoubleDouble, HasTheRootZeroOfZero) {
  EXPECT_EQ(sqrt(DoubleDouble{}), DoubleDouble{});
}

}  // namespace
}  // namespace kinestat
