#include "expression/evaluate/exact_arithmetic.hpp"

#include <cstdlib>
#include <utility>

namespace kinestat {

namespace {

constexpr int kLargestPiPower = 1000;

}  // namespace

MaybeExact limited(PiRational value) {
  if (std::abs(value.pi_power) > kLargestPiPower || !is_within_limit(value.factor)) {
    return std::nullopt;
  }
  value.pi_power = value.factor.is_zero() ? 0 : value.pi_power;
  return value;
}

PiRational negated(const PiRational& a) {
  return {Rational(-a.factor), a.pi_power};
}

MaybeExact add(const PiRational& a, const PiRational& b) {
  if (a.factor.is_zero()) {
    return b;
  }
  if (b.factor.is_zero()) {
    return a;
  }
  return a.pi_power == b.pi_power ? limited({Rational(a.factor + b.factor), a.pi_power})
                                  : std::nullopt;
}

MaybeExact subtract(const PiRational& a, const PiRational& b) {
  return add(a, negated(b));
}

MaybeExact multiply(const PiRational& a, const PiRational& b) {
  return limited({Rational(a.factor * b.factor), a.pi_power + b.pi_power});
}

MaybeExact divide(const PiRational& a, const PiRational& b) {
  if (b.factor.is_zero()) {
    return std::nullopt;
  }
  return limited({Rational(a.factor / b.factor), a.pi_power - b.pi_power});
}

MaybeExact raise(const PiRational& base, const PiRational& exponent) {
  const std::optional<Rational> factor =
      exponent.pi_power == 0 ? whole_power(base.factor, exponent.factor) : std::nullopt;
  if (!factor) {
    return std::nullopt;
  }
  if (base.pi_power == 0) {
    return PiRational{*factor, 0};
  }
  if (abs(exponent.factor) > kLargestPiPower) {
    return std::nullopt;
  }
  return limited({*factor, base.pi_power * exponent.factor.convert_to<int>()});
}

PiRational size_of(const UnitScale& unit) {
  return {Rational(Rational(unit.numerator) / Rational(unit.denominator)), unit.pi_power};
}

std::optional<int> compare(const PiRational& a, const PiRational& b) {
  const int sign_a = a.factor.sign();
  const int sign_b = b.factor.sign();
  if (sign_a != sign_b) {
    return sign_a < sign_b ? -1 : 1;
  }
  if (a.pi_power != b.pi_power) {
    return std::nullopt;
  }
  return a.factor < b.factor ? -1 : a.factor > b.factor ? 1 : 0;
}

}  // namespace kinestat
