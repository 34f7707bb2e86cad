// Whole numbers modulo a prime in which a turn has its parts: sines and cosines without rounding.
#pragma once

#include <cstdint>
#include <optional>

#include "math/numbers/rational.hpp"

namespace kinestat {

/// A prime p of 61 bits with N | p - 1, where N is the number of parts of a turn or four times,
/// twice that, so that there are an imaginary unit and all N roots of unity among the residues.
/// Then cos and sin of k/N turns are residues, and what sums, differences and products make of them
/// and of fractions is mapped without loss of what holds between them: what is zero stays zero, and
/// so a minor that is not zero modulo p is not zero. (Of the primes 2^61 - 1 has no eighth root.)
class PrimeField {
 public:
  using Value = std::uint64_t;  ///< below p

  /// The prime is drawn evenly from all that fit, so that no matrix can be made for it: the seed
  /// alone decides. 1 <= parts_of_a_turn <= 2^20.
  PrimeField(int parts_of_a_turn, std::uint64_t seed);

  Value modulus() const { return modulus_; }

  /// N.
  int root_count() const { return root_count_; }

  /// About how many primes there are to draw from (prime number theorem for arithmetic
  /// progressions).
  double prime_count() const;

  static bool is_zero(Value a) { return a == 0; }

  Value sum(Value a, Value b) const;
  Value difference(Value a, Value b) const;
  Value product(Value a, Value b) const;
  Value power(Value base, std::uint64_t exponent) const;

  /// b must not be zero.
  Value quotient(Value a, Value b) const;

  /// a += b.
  void add(Value& a, Value b) const { a = sum(a, b); }

  /// a -= b · c.
  void subtract_product(Value& a, Value b, Value c) const { a = difference(a, product(b, c)); }

  /// Empty if p divides the denominator.
  std::optional<Value> residue(const Rational& value) const;

  /// The image of exp(2πi k/N), for any whole k.
  Value root(std::int64_t k) const;

  /// Images of the cosine and sine of an angle in turns; empty if it is not a whole number of N-th
  /// parts.
  std::optional<Value> cosine(const Rational& turns) const;
  std::optional<Value> sine(const Rational& turns) const;

 private:
  std::optional<std::int64_t> parts_of(const Rational& turns) const;
  bool is_primitive(Value root) const;

  Value modulus_ = 0;
  int root_count_ = 0;
  Value root_ = 0;  ///< of order N
};

/// Euler's function: how many of 1, …, n have no divisor in common with n.
int totient(int n);

/// Calls `visit` with each prime divisor of n > 0 once, ascending.
template <class Visit>
void for_each_prime_divisor(int n, const Visit& visit) {
  for (int q = 2; q * q <= n; ++q) {
    if (n % q == 0) {
      visit(q);
    }
    while (n % q == 0) {
      n /= q;
    }
  }
  if (n > 1) {
    visit(n);
  }
}

}  // namespace kinestat
