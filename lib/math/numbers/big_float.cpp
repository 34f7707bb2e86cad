#include "math/numbers/big_float.hpp"

namespace kinestat {

const BigFloat& big_float_rounding() {
  static const BigFloat share = pow(BigFloat(10), 10 - kBigFloatDigits);
  return share;
}

const BigFloat& big_float_pi() {
  static const BigFloat value = acos(BigFloat(-1));
  return value;
}

BigFloat to_big_float(const Rational& value) {
  return BigFloat(boost::multiprecision::numerator(value)) /
         BigFloat(boost::multiprecision::denominator(value));
}

BigFloat settled_sum(const BigFloat& a, const BigFloat& b) {
  const BigFloat sum = a + b;
  return abs(sum) <= big_float_rounding() * (abs(a) + abs(b)) ? BigFloat(0) : sum;
}

BigFloatMemory::~BigFloatMemory() {
  mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE);
}

}  // namespace kinestat
