// Floating-point numbers of a hundred digits, for tasks whose data are typed as decimals.
#pragma once

#include <boost/multiprecision/mpfr.hpp>
#include <string>

namespace kinestat {

/// So many more than the hundred that are asked for at most (core/digit_limits.hpp) that what
/// binary digits round of a decimal is told from what someone typed.
inline constexpr int kBigFloatDigits = 120;

/// In place: without a memory allocation a number.
using BigFloat = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<kBigFloatDigits,
                                              boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

const BigFloat& big_float_pi();

/// a + b, and zero where no more is left of both than the rounding of their last ten digits:
/// 0.1 + 0.2 - 0.3 is zero.
BigFloat settled_sum(const BigFloat& a, const BigFloat& b);

/// The whole number that differs from `a` by no more than the rounding of its last ten digits, as
/// 0.3 / 0.1 does from 3; `a` itself if there is none.
BigFloat settled_whole(const BigFloat& a);

/// What MPFR keeps for each thread, as the digits of pi. A thread calls it when it has ended its
/// work; it may work with numbers again.
void release_big_float_memory();

}  // namespace kinestat
