#include "math/numbers/typed.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// k/n of half a turn.
Typed part_of_pi(int k, int n) {
  return Typed(k) / Typed(n) * typed_pi();
}

Typed third() {
  return Typed(1.0) / Typed(3.0);
}

TEST(Typed, KeepsFractions) {
  EXPECT_EQ(rational_of(third() + third() + third()), Rational(1));
  EXPECT_TRUE(is_zero(third() * Typed(3.0) - Typed(1.0)));
}

TEST(Typed, HasAHundredDigitsOfWhatHasNoFraction) {
  const Typed root = sqrt(Typed(2.0));

  EXPECT_LT(abs(*root.precise * *root.precise - 2), BigFloat("1e-95"));
  EXPECT_FALSE(rational_of(root).has_value());
}

TEST(Typed, SeesThatRootsOfSmallNumbersCancel) {
  EXPECT_TRUE(is_zero(sqrt(Typed(2.0)) * sqrt(Typed(3.0)) - sqrt(Typed(6.0))));
  EXPECT_TRUE(
      is_zero(sqrt(Typed(1001.0)) - sqrt(Typed(7.0)) * sqrt(Typed(11.0)) * sqrt(Typed(13.0))));
  EXPECT_EQ(rational_of(sqrt(Typed(1.0) / Typed(4.0))), Rational(1, 2));
}

// cos 20 deg is a root of 8 x^3 - 6 x - 1.
TEST(Typed, KnowsCosinesOfPartsOfATurn) {
  const Typed x = cos(part_of_pi(1, 9));

  const Typed left = Typed(8.0) * x * x * x - Typed(6.0) * x - Typed(1.0);

  ASSERT_TRUE(left.exact.has_value());
  EXPECT_TRUE(left.exact->is_zero());
}

TEST(Typed, KnowsTheSumOfEqualDirections) {
  Typed sum;
  for (int k = 0; k < 7; ++k) {
    sum = sum + sin(part_of_pi(2 * k + 1, 7));
  }

  ASSERT_TRUE(sum.exact.has_value());
  EXPECT_TRUE(is_zero(sum));
}

TEST(Typed, DividesByWhatIsNoFraction) {
  EXPECT_TRUE(is_zero(Typed(1.0) / sqrt(Typed(2.0)) - cos(part_of_pi(1, 4))));
}

TEST(Typed, KeepsDigitsWithoutAnExactValue) {
  const Typed root = sqrt(Typed(19.0));

  EXPECT_FALSE(root.exact.has_value());
  EXPECT_TRUE(is_zero(root * root - Typed(19.0)));
}

TEST(Typed, KeepsPowersOfPiApart) {
  const Typed sum = typed_pi() + Typed(1.0);

  EXPECT_FALSE(sum.exact.has_value());
  EXPECT_TRUE(is_zero(typed_pi() - typed_pi()));
  EXPECT_EQ((typed_pi() * typed_pi()).pi_power, 2);
}

TEST(Typed, DecidesByItsDouble) {
  const Typed sum = Typed(0.1) + Typed(0.2);

  EXPECT_EQ(value_of(sum), 0.1 + 0.2);
}

TEST(Typed, OfAZeroDivisorIsUnknown) {
  EXPECT_FALSE((Typed(1.0) / Typed(0.0)).precise.has_value());
}

}  // namespace
}  // namespace kinestat
