// Exact numbers that fractions and the sines and cosines of parts of a turn make.
#pragma once

#include <complex>
#include <map>
#include <optional>

#include "math/numbers/prime_field.hpp"
#include "math/numbers/rational.hpp"

namespace kinestat {

/// A sum of fractions times roots of unity exp(2πi k/N), as an element of the cyclotomic field of
/// order N; every one has one form, so that zero is seen. Whole degrees are such numbers with N =
/// 360, the directions of n planets with the least common multiple of 4 and n. Two that are
/// combined must have the same N.
class RootSum {
 public:
  /// 0, in any field.
  RootSum() = default;

  /// N must be a multiple of 4, so that the imaginary unit is one of the roots.
  RootSum(const Rational& value, int root_count);

  /// The cosine and sine of k/N turns.
  static RootSum cosine(int k, int root_count);
  static RootSum sine(int k, int root_count);

  int root_count() const { return root_count_; }

  bool is_zero() const { return terms_.empty(); }

  /// The same number in the field of a multiple of N.
  RootSum in_field(int root_count) const;

  /// The coefficients of the roots by k, none zero; only φ(N) of the k occur.
  const std::map<int, Rational>& terms() const { return terms_; }

  /// The number that this is, rounded.
  std::complex<double> value() const;

  /// Its image in a field of the same N; empty if the prime divides a denominator.
  std::optional<PrimeField::Value> residue(const PrimeField& field) const;

  /// Its reciprocal; it must not be zero. Solves φ(N) equations.
  RootSum inverse() const;

  RootSum operator-() const;
  RootSum& operator+=(const RootSum& other);

  RootSum& operator-=(const RootSum& other) { return *this += -other; }

  friend RootSum operator+(RootSum a, const RootSum& b) { return a += b; }

  friend RootSum operator-(RootSum a, const RootSum& b) { return a -= b; }

  friend RootSum operator*(const RootSum& a, const RootSum& b);

  friend bool operator==(const RootSum& a, const RootSum& b) { return a.terms_ == b.terms_; }

 private:
  static RootSum root(int k, int root_count);
  void add_term(int k, const Rational& factor);
  void reduce(int prime);
  void reduce();

  int root_count_ = 0;
  std::map<int, Rational> terms_;
};

}  // namespace kinestat
