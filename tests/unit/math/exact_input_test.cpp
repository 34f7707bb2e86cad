#include "math/numbers/exact_input.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// k/n of half a turn.
ExactInput part_of_pi(int k, int n) {
  return ExactInput(k) / ExactInput(n) * exact_input_pi();
}

ExactInput third() {
  return ExactInput(1.0) / ExactInput(3.0);
}

TEST(ExactInput, KeepsFractions) {
  EXPECT_EQ(rational_of(third() + third() + third()), Rational(1));
  EXPECT_TRUE(is_zero(third() * ExactInput(3.0) - ExactInput(1.0)));
}

TEST(ExactInput, HasAHundredDigitsOfWhatHasNoFraction) {
  const ExactInput root = sqrt(ExactInput(2.0));

  EXPECT_LT(abs(*root.precise * *root.precise - 2), BigFloat("1e-95"));
  EXPECT_FALSE(rational_of(root).has_value());
}

TEST(ExactInput, SeesThatRootsOfSmallNumbersCancel) {
  EXPECT_TRUE(is_zero(sqrt(ExactInput(2.0)) * sqrt(ExactInput(3.0)) - sqrt(ExactInput(6.0))));
  EXPECT_TRUE(is_zero(sqrt(ExactInput(1001.0)) -
                      sqrt(ExactInput(7.0)) * sqrt(ExactInput(11.0)) * sqrt(ExactInput(13.0))));
  EXPECT_EQ(rational_of(sqrt(ExactInput(1.0) / ExactInput(4.0))), Rational(1, 2));
}

// cos 20 deg is a root of 8 x^3 - 6 x - 1.
TEST(ExactInput, KnowsCosinesOfPartsOfATurn) {
  const ExactInput x = cos(part_of_pi(1, 9));

  const ExactInput left = ExactInput(8.0) * x * x * x - ExactInput(6.0) * x - ExactInput(1.0);

  ASSERT_TRUE(left.exact.has_value());
  EXPECT_TRUE(left.exact->is_zero());
}

TEST(ExactInput, KnowsTheSumOfEqualDirections) {
  ExactInput sum;
  for (int k = 0; k < 7; ++k) {
    sum = sum + sin(part_of_pi(2 * k + 1, 7));
  }

  ASSERT_TRUE(sum.exact.has_value());
  EXPECT_TRUE(is_zero(sum));
}

TEST(ExactInput, DividesByWhatIsNoFraction) {
  EXPECT_TRUE(is_zero(ExactInput(1.0) / sqrt(ExactInput(2.0)) - cos(part_of_pi(1, 4))));
}

TEST(ExactInput, KeepsDigitsWithoutAnExactValue) {
  const ExactInput root = sqrt(ExactInput(19.0));

  EXPECT_FALSE(root.exact.has_value());
  EXPECT_TRUE(is_zero(root * root - ExactInput(19.0)));
}

TEST(ExactInput, KeepsPowersOfPiApart) {
  const ExactInput sum = exact_input_pi() + ExactInput(1.0);

  EXPECT_FALSE(sum.exact.has_value());
  EXPECT_TRUE(is_zero(exact_input_pi() - exact_input_pi()));
  EXPECT_EQ((exact_input_pi() * exact_input_pi()).pi_power, 2);
}

TEST(ExactInput, DecidesByItsDouble) {
  const ExactInput sum = ExactInput(0.1) + ExactInput(0.2);

  EXPECT_EQ(value_of(sum), 0.1 + 0.2);
}

TEST(ExactInput, OfAZeroDivisorIsUnknown) {
  EXPECT_FALSE((ExactInput(1.0) / ExactInput(0.0)).precise.has_value());
}

}  // namespace
}  // namespace kinestat
