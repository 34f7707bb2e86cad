#include "math/numbers/root_sum.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/random_fractions.hpp"

namespace kinestat {
namespace {

RootSum number(const Rational& value, int root_count) {
  return {value, root_count};
}

TEST(RootSum, OfAllRootsIsZero) {
  for (const int n : {4, 12, 20, 28, 36, 360}) {
    RootSum sum;
    for (int k = 0; k < n; ++k) {
      sum += RootSum::cosine(k, n);
    }

    EXPECT_TRUE(sum.is_zero()) << n;
  }
}

TEST(RootSum, KnowsTheCosinesThatAreFractions) {
  EXPECT_EQ(RootSum::cosine(60, 360), number(Rational(1, 2), 360));
  EXPECT_EQ(RootSum::cosine(120, 360), number(Rational(-1, 2), 360));
  EXPECT_EQ(RootSum::cosine(90, 360), RootSum());
  EXPECT_EQ(RootSum::sine(30, 360), number(Rational(1, 2), 360));
  EXPECT_EQ(RootSum::sine(-90, 360), number(Rational(-1), 360));
}

// sin 60° sin 60° = 3/4; 4 cos² 36° - 2 cos 36° = 1; sin 18° cos 36° = 1/4.
TEST(RootSum, KnowsProductsOfRoots) {
  const RootSum x = RootSum::cosine(36, 360);

  EXPECT_EQ(RootSum::sine(60, 360) * RootSum::sine(60, 360), number(Rational(3, 4), 360));
  EXPECT_EQ(number(4, 360) * x * x - number(2, 360) * x, number(1, 360));
  EXPECT_EQ(RootSum::sine(18, 360) * x, number(Rational(1, 4), 360));
}

TEST(RootSum, HasAtMostAsManyTermsAsEulersFunction) {
  RootSum sum;
  for (int k = 0; k < 360; ++k) {
    sum += number(Rational(k * k + 1), 360) * RootSum::cosine(k, 360);
  }

  EXPECT_LE(sum.terms().size(), 96U);
}

class RootSums : public ::testing::TestWithParam<int> {
 protected:
  RootSum random_number() {
    RootSum sum = number(random_fraction(random_), kRoots);
    for (int i = 0; i < 3; ++i) {
      const int k = random_.whole(-100, 100);
      sum += number(random_fraction(random_), kRoots) *
             (random_.chance(0.5) ? RootSum::cosine(k, kRoots) : RootSum::sine(k, kRoots));
    }
    return sum;
  }

  static constexpr int kRoots = 60;
  Random random_{static_cast<std::uint64_t>(GetParam())};
};

INSTANTIATE_TEST_SUITE_P(Seed, RootSums, ::testing::Range(0, 10));

TEST_P(RootSums, AreTheCosinesAndSinesOfTheLibrary) {
  const int k = random_.whole(-400, 400);
  const double angle = 2.0 * std::numbers::pi * k / 360;

  EXPECT_LE(std::abs(RootSum::cosine(k, 360).value() - std::cos(angle)), 1e-13);
  EXPECT_LE(std::abs(RootSum::sine(k, 360).value() - std::sin(angle)), 1e-13);
}

TEST_P(RootSums, MultiplyAndAddAsTheirRoundedValuesDo) {
  const RootSum a = random_number();
  const RootSum b = random_number();

  EXPECT_LE(std::abs((a * b).value() - a.value() * b.value()), 1e-10);
  EXPECT_LE(std::abs((a - b).value() - (a.value() - b.value())), 1e-10);
}

TEST_P(RootSums, DoNotDependOnTheOrderOfTheirTerms) {
  const RootSum a = random_number();
  const RootSum b = random_number();
  const RootSum c = random_number();

  EXPECT_EQ(a * (b + c), c * a + b * a);
  EXPECT_EQ((a * b) * c, (c * b) * a);
  EXPECT_TRUE((a + b - a - b).is_zero());
}

TEST_P(RootSums, HaveReciprocals) {
  const RootSum a = random_number();

  EXPECT_EQ(a * a.inverse(), number(1, kRoots));
}

TEST_P(RootSums, HaveImagesInAPrimeFieldThatAddAndMultiply) {
  const PrimeField field(kRoots, static_cast<std::uint64_t>(GetParam()));
  const RootSum a = random_number();
  const RootSum b = random_number();

  EXPECT_EQ((a * b).residue(field), field.product(*a.residue(field), *b.residue(field)));
  EXPECT_EQ((a + b).residue(field), field.sum(*a.residue(field), *b.residue(field)));
}

TEST_P(RootSums, HaveTheImagesThatAPrimeFieldHasOfAngles) {
  const PrimeField field(kRoots, static_cast<std::uint64_t>(GetParam()));
  const int k = random_.whole(-100, 100);

  EXPECT_EQ(RootSum::cosine(k, kRoots).residue(field), field.cosine(Rational(k, kRoots)));
  EXPECT_EQ(RootSum::sine(k, kRoots).residue(field), field.sine(Rational(k, kRoots)));
}

}  // namespace
}  // namespace kinestat
