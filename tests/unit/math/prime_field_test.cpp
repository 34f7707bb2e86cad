#include "math/numbers/prime_field.hpp"

#include <gtest/gtest.h>

#include "math/elimination/internal/modular_field.hpp"
#include "support/random_fractions.hpp"

namespace kinestat {
namespace {

using Value = PrimeField::Value;

TEST(PrimeField, HasAPrimeOf61BitsWithThePartsOfATurn) {
  for (const int parts : {1, 3, 7, 360, 720, 27720}) {
    const PrimeField field(parts, 1);

    EXPECT_EQ(field.modulus() >> 60U, 1U) << parts;
    EXPECT_EQ(field.root_count() % parts, 0) << parts;
    EXPECT_EQ((field.modulus() - 1) % static_cast<Value>(field.root_count()), 0U) << parts;
  }
}

// Fermat's little theorem holds for bases of our own choice; composites would have to be lucky.
TEST(PrimeField, HasAPrime) {
  const PrimeField field(360, 2);

  for (const Value base : {2U, 3U, 5U, 7U, 11U, 13U}) {
    EXPECT_EQ(field.power(base, field.modulus() - 1), 1U);
  }
}

TEST(PrimeField, DrawsAnotherPrimeForAnotherSeedAndTheSameForTheSame) {
  EXPECT_EQ(PrimeField(360, 3).modulus(), PrimeField(360, 3).modulus());
  EXPECT_NE(PrimeField(360, 3).modulus(), PrimeField(360, 4).modulus());
}

TEST(PrimeField, MultipliesLikeWholeNumbers) {
  const PrimeField field(4, 5);
  const Value a = field.modulus() - 3;
  const Value b = field.modulus() / 2;

  EXPECT_EQ(Integer(field.product(a, b)), Integer(a) * b % field.modulus());
}

class PrimeFields : public ::testing::TestWithParam<int> {
 protected:
  PrimeField field_{360, static_cast<std::uint64_t>(GetParam())};
  Random random_{static_cast<std::uint64_t>(GetParam())};
};

INSTANTIATE_TEST_SUITE_P(Seed, PrimeFields, ::testing::Range(0, 10));

TEST_P(PrimeFields, KeepSumsAndProductsOfFractions) {
  const Rational a = random_fraction(random_);
  const Rational b = random_fraction(random_);
  const Value x = *field_.residue(a);
  const Value y = *field_.residue(b);

  EXPECT_EQ(field_.residue(a + b), field_.sum(x, y));
  EXPECT_EQ(field_.residue(a - b), field_.difference(x, y));
  EXPECT_EQ(field_.residue(a * b), field_.product(x, y));
  EXPECT_EQ(field_.residue(a / b), field_.quotient(x, y));
}

TEST_P(PrimeFields, TakeADoubleForTheFractionThatItIs) {
  for (const double value : {0.0, 1.0, -3.0, 0.1, -1.0 / 3.0, 1e300, 5e-324, 1e-9}) {
    EXPECT_EQ(residue_of(value, field_), field_.residue(Rational(value))) << value;
  }
}

TEST_P(PrimeFields, KeepTheRulesOfSinesAndCosines) {
  const Rational a(random_.whole(-400, 400), 360);
  const Rational b(random_.whole(-400, 400), 360);
  const Value cos_a = *field_.cosine(a);
  const Value sin_a = *field_.sine(a);
  const Value cos_b = *field_.cosine(b);
  const Value sin_b = *field_.sine(b);

  EXPECT_EQ(field_.sum(field_.product(cos_a, cos_a), field_.product(sin_a, sin_a)), 1U);
  EXPECT_EQ(field_.cosine(a + b),
            field_.difference(field_.product(cos_a, cos_b), field_.product(sin_a, sin_b)));
  EXPECT_EQ(field_.sine(a + b),
            field_.sum(field_.product(sin_a, cos_b), field_.product(cos_a, sin_b)));
}

TEST_P(PrimeFields, KnowTheAnglesWithRationalValues) {
  EXPECT_EQ(field_.cosine(Rational(1, 6)), field_.residue(Rational(1, 2)));
  EXPECT_EQ(field_.cosine(Rational(1, 3)), field_.residue(Rational(-1, 2)));
  EXPECT_EQ(field_.sine(Rational(1, 12)), field_.residue(Rational(1, 2)));
  EXPECT_EQ(field_.sine(Rational(1, 4)), 1U);
  EXPECT_EQ(field_.cosine(Rational(1, 4)), 0U);
}

// cos 36° is the larger root of 4 x² - 2 x - 1.
TEST_P(PrimeFields, KnowTheGoldenRatio) {
  const Value x = *field_.cosine(Rational(1, 10));

  EXPECT_EQ(field_.product(field_.product(4, x), x), field_.sum(field_.product(2, x), 1));
}

TEST_P(PrimeFields, HaveNoAnglesBetweenTheirParts) {
  EXPECT_FALSE(field_.cosine(Rational(1, 720)).has_value());
  EXPECT_FALSE(field_.sine(Rational(1, 7)).has_value());
}

TEST_P(PrimeFields, HaveNoFractionsOfTheirPrime) {
  EXPECT_FALSE(field_.residue(Rational(Integer(1), Integer(field_.modulus()))).has_value());
}

TEST(Totient, CountsWhatHasNoDivisorInCommon) {
  EXPECT_EQ(totient(1), 1);
  EXPECT_EQ(totient(12), 4);
  EXPECT_EQ(totient(13), 12);
  EXPECT_EQ(totient(360), 96);
}

}  // namespace
}  // namespace kinestat
