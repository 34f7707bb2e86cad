#include "math/numbers/bounded_number.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "math/numbers/rational.hpp"

namespace kinestat {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Numbers of all sizes, each with a true value that lies at an end of its bound or within it.
class Sampler {
 public:
  std::pair<BoundedNumber, Rational> draw() {
    const double value = std::ldexp(uniform(), exponent_(generator_));
    const double bound = std::abs(value) * std::ldexp(1.0, -uncertain_(generator_));
    const double share = std::ldexp(std::round(8.0 * uniform()), -3);
    return {{.value = value, .bound = bound}, Rational(value) + Rational(share) * Rational(bound)};
  }

 private:
  double uniform() { return uniform_(generator_); }

  std::mt19937 generator_{20261122};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
  std::uniform_int_distribution<int> exponent_{-60, 60};
  std::uniform_int_distribution<int> uncertain_{1, 60};
};

void expect_within(const BoundedNumber& found, const Rational& truth) {
  if (std::isfinite(found.bound)) {
    EXPECT_LE(abs(truth - Rational(found.value)), Rational(found.bound));
  }
}

TEST(BoundedNumber, CoversWhatTheTrueNumbersGive) {
  Sampler sampler;
  for (int i = 0; i < 20000; ++i) {
    const auto [a, true_a] = sampler.draw();
    const auto [b, true_b] = sampler.draw();

    expect_within(a + b, true_a + true_b);
    expect_within(a * b, true_a * true_b);
    expect_within(a / b, true_a / true_b);
  }
}

TEST(BoundedNumber, IsNotFarFromTheWorstThatCanHappen) {
  const BoundedNumber a{.value = 3.0, .bound = 1e-6};
  const BoundedNumber b{.value = 7.0, .bound = 1e-8};

  EXPECT_NEAR((a + b).bound, 1.01e-6, 1e-14);
  EXPECT_NEAR((a * b).bound, 7e-6 + 3e-8, 1e-13);
  EXPECT_NEAR((a / b).bound, (1e-6 + 3.0 / 7.0 * 1e-8) / 7.0, 1e-14);
}

TEST(BoundedNumber, IsOffByAShareOfItself) {
  EXPECT_EQ((BoundedNumber{.value = -8.0, .bound = 0.25}.relative_bound()), 0.03125);
  EXPECT_EQ((BoundedNumber{.value = 8.0, .bound = 8.0}.relative_bound()), 1.0);
  EXPECT_EQ((BoundedNumber{.value = 0.0, .bound = 0.0}.relative_bound()), 0.0);
}

TEST(BoundedNumber, OfExactNumbersHasTheRoundingOfTheResult) {
  const BoundedNumber third = BoundedNumber{.value = 1.0} / BoundedNumber{.value = 3.0};

  EXPECT_GE(third.bound, std::abs(1.0 / 3.0) * 0x1p-54);
  EXPECT_LE(third.relative_bound(), 1.2e-16);
}

TEST(BoundedNumber, OfADivisorThatMayBeZeroPromisesNothing) {
  const BoundedNumber one{.value = 1.0};
  const BoundedNumber maybe_zero{.value = 1e-3, .bound = 1e-3};

  EXPECT_EQ((one / maybe_zero).bound, kInfinity);
  EXPECT_EQ((one / maybe_zero).relative_bound(), 1.0);
}

TEST(BoundedNumber, ThatIsSurelyZeroHasNoError) {
  const BoundedNumber zero;

  EXPECT_EQ((zero + zero).relative_bound(), 0.0);
  EXPECT_EQ((zero * BoundedNumber{.value = 5.0, .bound = 1.0}).bound, 0.0);
  EXPECT_EQ((zero / BoundedNumber{.value = 5.0, .bound = 1.0}).bound, 0.0);
}

TEST(BoundedNumber, BelowTheSmallestOneIsNotSurelyZero) {
  const BoundedNumber tiny{.value = 1e-200};

  EXPECT_EQ((tiny * tiny).value, 0.0);
  EXPECT_GT((tiny * tiny).bound, 0.0);
}

TEST(BoundedNumber, OfAnInfiniteBoundHasOne) {
  const BoundedNumber unknown{.value = 2.0, .bound = kInfinity};

  EXPECT_EQ((BoundedNumber{.value = 0.0, .bound = 1.0} * unknown).bound, kInfinity);
  EXPECT_EQ((unknown + BoundedNumber{.value = -2.0}).bound, kInfinity);
}

}  // namespace
}  // namespace kinestat
