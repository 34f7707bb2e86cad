#include "math/numbers/big_float.hpp"

namespace kinestat {

namespace {

// Of the sizes of the terms of a sum.
const BigFloat& rounding() {
  static const BigFloat share = pow(BigFloat(10), 10 - kBigFloatDigits);
  return share;
}

}  // namespace

const BigFloat& big_float_pi() {
  static const BigFloat value = acos(BigFloat(-1));
  return value;
}

BigFloat settled_sum(const BigFloat& a, const BigFloat& b) {
  const BigFloat sum = a + b;
  return abs(sum) <= rounding() * (abs(a) + abs(b)) ? BigFloat(0) : sum;
}

BigFloat settled_whole(const BigFloat& a) {
  const BigFloat nearest = round(a);
  return abs(a - nearest) <= rounding() * abs(a) ? nearest : a;
}

void release_big_float_memory() {
  mpfr_free_cache();
}

}  // namespace kinestat
