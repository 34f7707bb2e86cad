// A prime field for elimination.
#pragma once

#include "math/numbers/prime_field.hpp"

namespace kinestat {

/// The operations of elimination, which are inline; the reciprocal of a pivot serves all rows below
/// it.
struct ModularField {
  using Value = PrimeField::Value;

  PrimeField prime;
  Value divisor = 1;
  Value reciprocal = 1;

  static bool is_zero(Value a) { return a == 0; }

  Value product(Value a, Value b) const {
    __extension__ using Wide = unsigned __int128;
    return static_cast<Value>(Wide{a} * b % prime.modulus());
  }

  Value quotient(Value a, Value b) {
    if (b != divisor) {
      divisor = b;
      reciprocal = prime.quotient(1, b);
    }
    return product(a, reciprocal);
  }

  void add(Value& a, Value b) const { a = prime.sum(a, b); }

  void subtract_product(Value& a, Value b, Value c) const {
    const Value term = product(b, c);
    a = a >= term ? a - term : a + prime.modulus() - term;
  }
};

/// The residue of the fraction that a finite double is; its denominator is a power of two.
PrimeField::Value residue_of(double value, const PrimeField& field);

}  // namespace kinestat
