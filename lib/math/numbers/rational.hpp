// Exact fractions of whole numbers, and the questions about them that have an exact answer.
#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <optional>
#include <string_view>

namespace kinestat {

/// A whole number of any size.
using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// A fraction in lowest terms with a positive denominator.
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

/// [bits] of a numerator or denominator. Decimals in the range of double need up to 1100; what
/// grows beyond this limit is no longer worth its time.
inline constexpr unsigned kLargestRational = 4096;

/// Whether numerator and denominator stay within kLargestRational.
bool is_within_limit(const Rational& value);

bool is_whole(const Rational& value);

/// The value of a decimal as typed, digit by digit: "0.1" is 1/10, "-1e-3" is -1/1000. Digits with
/// an optional sign, point and exponent, as the scanner of expressions accepts them; anything else
/// is a bug. Empty beyond kLargestRational, whatever the exponent.
std::optional<Rational> read_decimal(std::string_view literal);

/// The double nearest to the value, ties to even; beyond its range the largest one or infinity.
double to_double(const Rational& value);

/// The largest whole number that is not above the value.
Rational rounded_down(const Rational& value);

/// A whole power. Empty for other exponents, beyond kLargestRational, and for a negative power of
/// zero; 0^0 is 1.
std::optional<Rational> whole_power(const Rational& base, const Rational& exponent);

/// The root that is not negative; empty unless the value is the square of a fraction.
std::optional<Rational> exact_square_root(const Rational& value);

/// The greatest common divisor of two whole numbers, not negative; gcd(0, 0) is 0.
Rational common_divisor(const Rational& a, const Rational& b);

}  // namespace kinestat
