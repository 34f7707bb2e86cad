// A number as typed: the double that stands for it, a hundred digits of it, and its exact value
// where it has one.
#pragma once

#include <optional>

#include "math/numbers/big_float.hpp"
#include "math/numbers/root_sum.hpp"

namespace kinestat {

/// What arithmetic keeps of a number beside its double. Exact are fractions, sines and cosines of
/// parts of a turn, square roots of small whole numbers, and what + - * / make of them; all times
/// a power of pi.
struct ExactInput {
  double value = 0.0;                             ///< what arithmetic with double gives; it decides
  std::optional<BigFloat> precise = BigFloat(0);  ///< empty: not known
  std::optional<RootSum> exact = RootSum(Rational(0), 4);  ///< empty: not known
  int pi_power = 0;                                        ///< of the exact value; 0 of zero

  ExactInput() = default;

  /// This very double. Not explicit: numbers mix in formulas.
  ExactInput(double number);

  ExactInput(double number,
             std::optional<BigFloat> digits,
             std::optional<RootSum> root_sum,
             int power);
};

/// A fraction, if the number is known to be one.
std::optional<Rational> rational_of(const ExactInput& number);

/// Whether the number is known to be zero, or zero in all its digits.
bool is_zero(const ExactInput& number);

/// For decisions that double arithmetic takes.
inline double value_of(const ExactInput& number) {
  return number.value;
}

/// pi itself.
ExactInput exact_input_pi();

ExactInput operator-(const ExactInput& a);
ExactInput operator+(const ExactInput& a, const ExactInput& b);
ExactInput operator-(const ExactInput& a, const ExactInput& b);
ExactInput operator*(const ExactInput& a, const ExactInput& b);

/// Nothing is known of a division by zero but its double.
ExactInput operator/(const ExactInput& a, const ExactInput& b);

/// The exact value is known of the root of a fraction whose square-free part is made of the primes
/// up to 13 (Gauss sums).
ExactInput sqrt(const ExactInput& a);

/// Exact for whole parts of a turn.
ExactInput sin(const ExactInput& a);
ExactInput cos(const ExactInput& a);
ExactInput tan(const ExactInput& a);

/// Exact of zero only.
ExactInput atan(const ExactInput& a);

ExactInput abs(const ExactInput& a);

}  // namespace kinestat
