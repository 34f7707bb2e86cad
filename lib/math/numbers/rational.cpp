#include "math/numbers/rational.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "core/contract.hpp"

namespace kinestat {

namespace {

unsigned bit_count(const Integer& value) {
  return value.is_zero() ? 0U : static_cast<unsigned>(msb(abs(value))) + 1U;
}

Integer numerator_of(const Rational& value) {
  return boost::multiprecision::numerator(value);
}

Integer denominator_of(const Rational& value) {
  return boost::multiprecision::denominator(value);
}

Integer power_of(const Integer& base, unsigned exponent) {
  return boost::multiprecision::pow(base, exponent);
}

// A decimal as the whole number of its digits times a power of ten.
struct Decimal {
  bool is_negative = false;
  std::string digits;  // without leading zeros; empty for zero
  long long exponent = 0;
};

// The sign and digits after the 'e'; beyond the range of long long its end.
long long read_exponent(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  text.remove_prefix(is_negative || text.starts_with('+') ? 1 : 0);
  long long value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  KINESTAT_EXPECTS(end == text.data() + text.size() && !text.empty());
  if (fault == std::errc::result_out_of_range) {
    value = std::numeric_limits<int>::max();
  }
  value = std::min<long long>(value, std::numeric_limits<int>::max());
  return is_negative ? -value : value;
}

Decimal split(std::string_view literal) {
  Decimal result{.is_negative = literal.starts_with('-'), .digits = {}, .exponent = 0};
  literal.remove_prefix(result.is_negative || literal.starts_with('+') ? 1 : 0);
  const std::size_t mark = literal.find_first_of("eE");
  const std::string_view mantissa = literal.substr(0, mark);
  const std::size_t point = mantissa.find('.');
  result.digits = mantissa.substr(0, point);
  if (point != std::string_view::npos) {
    result.digits += mantissa.substr(point + 1);
    result.exponent = -static_cast<long long>(mantissa.size() - point - 1);
  }
  KINESTAT_EXPECTS(result.digits.find_first_not_of("0123456789") == std::string::npos &&
                   !result.digits.empty());
  result.digits.erase(0, std::min(result.digits.find_first_not_of('0'), result.digits.size()));
  if (mark != std::string_view::npos) {
    result.exponent += read_exponent(literal.substr(mark + 1));
  }
  return result;
}

}  // namespace

bool is_within_limit(const Rational& value) {
  return bit_count(numerator_of(value)) <= kLargestRational &&
         bit_count(denominator_of(value)) <= kLargestRational;
}

bool is_whole(const Rational& value) {
  return denominator_of(value) == 1;
}

std::optional<Rational> read_decimal(std::string_view literal) {
  // Generous: a decimal digit has more than three bits, and a common factor of ten may cancel.
  constexpr long long kFarthestDigit = 2LL * kLargestRational;
  const Decimal decimal = split(literal);
  if (decimal.digits.empty()) {
    return Rational(0);
  }
  if (decimal.exponent > kFarthestDigit || decimal.exponent < -kFarthestDigit ||
      decimal.digits.size() > kFarthestDigit) {
    return std::nullopt;
  }
  const Integer digits(decimal.digits);
  const Integer scale = power_of(Integer(10), static_cast<unsigned>(std::abs(decimal.exponent)));
  const Rational size = decimal.exponent < 0 ? Rational(digits, scale) : Rational(digits * scale);
  const Rational value = decimal.is_negative ? Rational(-size) : size;
  return is_within_limit(value) ? std::optional(value) : std::nullopt;
}

double to_double(const Rational& value) {
  // GMP cuts off towards zero: the nearest double is this one or the next outwards.
  const double inner = mpq_get_d(value.backend().data());
  const double outer = std::nextafter(inner,
                                      value < 0 ? -std::numeric_limits<double>::infinity()
                                                : std::numeric_limits<double>::infinity());
  if (std::isinf(inner) || std::isinf(outer) || value.is_zero()) {
    return inner;
  }
  const Rational to_inner = abs(Rational(value - Rational(inner)));
  const Rational to_outer = abs(Rational(Rational(outer) - value));
  if (to_inner == to_outer) {
    return std::bit_cast<std::uint64_t>(inner) % 2 == 0 ? inner : outer;
  }
  return to_inner < to_outer ? inner : outer;
}

Rational rounded_down(const Rational& value) {
  Integer quotient;
  mpz_fdiv_q(quotient.backend().data(),
             mpq_numref(value.backend().data()),
             mpq_denref(value.backend().data()));
  return Rational(quotient);
}

std::optional<Rational> whole_power(const Rational& base, const Rational& exponent) {
  if (!is_whole(exponent) || (base.is_zero() && exponent < 0)) {
    return std::nullopt;
  }
  if (exponent.is_zero() || base == 1) {
    return Rational(1);
  }
  if (base.is_zero()) {
    return Rational(0);
  }
  if (base == -1) {
    return Rational(numerator_of(exponent) % 2 == 0 ? 1 : -1);
  }
  // Any other base has a part of at least two bits, which each factor makes longer.
  if (abs(exponent) > kLargestRational) {
    return std::nullopt;
  }
  const auto count = abs(numerator_of(exponent)).convert_to<unsigned>();
  const unsigned bits = std::max(bit_count(numerator_of(base)), bit_count(denominator_of(base)));
  if ((bits - 1) * count > kLargestRational) {
    return std::nullopt;
  }
  const Rational raised(power_of(numerator_of(base), count), power_of(denominator_of(base), count));
  const Rational result = exponent < 0 ? Rational(1 / raised) : raised;
  return is_within_limit(result) ? std::optional(result) : std::nullopt;
}

std::optional<Rational> exact_square_root(const Rational& value) {
  const Integer above = numerator_of(value);
  const Integer below = denominator_of(value);
  if (above < 0 || mpz_perfect_square_p(above.backend().data()) == 0 ||
      mpz_perfect_square_p(below.backend().data()) == 0) {
    return std::nullopt;
  }
  return Rational(Integer(sqrt(above)), Integer(sqrt(below)));
}

Rational common_divisor(const Rational& a, const Rational& b) {
  KINESTAT_EXPECTS(is_whole(a) && is_whole(b));
  return Rational(Integer(gcd(numerator_of(a), numerator_of(b))));
}

}  // namespace kinestat
