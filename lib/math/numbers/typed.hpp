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
struct Typed {
  double value = 0.0;                             ///< what arithmetic with double gives; it decides
  std::optional<BigFloat> precise = BigFloat(0);  ///< empty: not known
  std::optional<RootSum> exact = RootSum(Rational(0), 4);  ///< empty: not known
  int pi_power = 0;                                        ///< of the exact value; 0 of zero

  Typed() = default;

  /// This very double. Not explicit: numbers mix in formulas.
  Typed(double number);

  Typed(double number, std::optional<BigFloat> digits, std::optional<RootSum> root_sum, int power);
};

/// A fraction, if the number is known to be one.
std::optional<Rational> rational_of(const Typed& number);

/// Whether the number is known to be zero, or zero in all its digits.
bool is_zero(const Typed& number);

/// For decisions that double arithmetic takes.
inline double value_of(const Typed& number) {
  return number.value;
}

/// pi itself.
Typed typed_pi();

Typed operator-(const Typed& a);
Typed operator+(const Typed& a, const Typed& b);
Typed operator-(const Typed& a, const Typed& b);
Typed operator*(const Typed& a, const Typed& b);

/// Nothing is known of a division by zero but its double.
Typed operator/(const Typed& a, const Typed& b);

/// The exact value is known of the root of a fraction whose square-free part is made of the primes
/// up to 13 (Gauss sums).
Typed sqrt(const Typed& a);

/// Exact for whole parts of a turn.
Typed sin(const Typed& a);
Typed cos(const Typed& a);
Typed tan(const Typed& a);

/// Exact of zero only.
Typed atan(const Typed& a);

Typed abs(const Typed& a);

}  // namespace kinestat
