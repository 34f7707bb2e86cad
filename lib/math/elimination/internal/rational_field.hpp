// Fractions as a field for elimination.
#pragma once

#include "math/numbers/rational.hpp"

namespace kinestat {

/// The operations of Boost make a new number each; these of GMP work in place.
struct RationalField {
  using Value = Rational;

  static bool is_zero(const Rational& a) { return a.is_zero(); }

  static Rational quotient(const Rational& a, const Rational& b) { return a / b; }

  static void add(Rational& a, const Rational& b) { a += b; }

  void subtract_product(Rational& a, const Rational& b, const Rational& c) {
    mpq_mul(product_.backend().data(), b.backend().data(), c.backend().data());
    mpq_sub(a.backend().data(), a.backend().data(), product_.backend().data());
  }

  Rational product_;
};

}  // namespace kinestat
