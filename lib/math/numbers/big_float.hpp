// Floating-point numbers of a hundred digits, for tasks whose data are typed as decimals.
#pragma once

#include <boost/multiprecision/mpfr.hpp>

#include "core/digit_limits.hpp"
#include "math/numbers/rational.hpp"

namespace kinestat {

/// Binary digits round decimals, and what follows from them: so many more are kept than may be
/// asked for.
inline constexpr int kBigFloatDigits = kMostDigits + 20;

/// Held in place: a number allocates no memory.
using BigFloat = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<kBigFloatDigits,
                                              boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

/// As a share of what it is a sum of, a number that rounding may have left where zero should be:
/// its last ten digits.
const BigFloat& big_float_rounding();

const BigFloat& big_float_pi();

/// With all its digits.
BigFloat to_big_float(const Rational& value);

/// a + b, or zero if that may be rounding of a and b: 1.1*1.1 - 1.21 is zero.
BigFloat settled_sum(const BigFloat& a, const BigFloat& b);

/// Gives back what MPFR keeps for the thread that it is made in, as the digits of pi.
struct BigFloatMemory {
  BigFloatMemory() = default;
  BigFloatMemory(const BigFloatMemory&) = delete;
  BigFloatMemory& operator=(const BigFloatMemory&) = delete;
  ~BigFloatMemory();
};

}  // namespace kinestat
