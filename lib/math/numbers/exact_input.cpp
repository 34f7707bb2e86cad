#include "math/numbers/exact_input.hpp"

#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/tolerance.hpp"
#include "math/numbers/typed_angle.hpp"

namespace kinestat {

namespace {

// Roots of unity that numbers are made of, and the largest degree of their field: products of such
// numbers take milliseconds.
constexpr int kMostRoots = 1440;
constexpr int kMostDegree = 96;

// An inverse solves as many equations.
constexpr int kLargestInvertedDegree = 24;

using MaybeRoots = std::optional<RootSum>;
using MaybePrecise = std::optional<BigFloat>;

MaybePrecise finite(BigFloat value) {
  return isfinite(value) ? MaybePrecise(std::move(value)) : std::nullopt;
}

// The number of roots of a field that holds both; empty if it is too large.
std::optional<int> common_root_count(int a, int b) {
  const int count = std::lcm(a, b);
  return count <= kMostRoots && totient(count) <= kMostDegree ? std::optional(count) : std::nullopt;
}

bool is_small(const RootSum& sum) {
  for (const auto& [k, factor] : sum.terms()) {
    if (!is_within_limit(factor)) {
      return false;
    }
  }
  return true;
}

// Calls `combine` with both numbers in one field.
template <class Combine>
MaybeRoots combined(const RootSum& a, const RootSum& b, const Combine& combine) {
  const std::optional<int> count = common_root_count(a.root_count(), b.root_count());
  if (!count) {
    return std::nullopt;
  }
  RootSum result = combine(a.in_field(*count), b.in_field(*count));
  const bool is_fraction = result.terms().size() == 1 && result.terms().contains(0);
  if (result.is_zero()) {
    return RootSum(Rational(0), 4);
  }
  if (is_fraction) {
    result = RootSum(result.terms().at(0), 4);
  }
  return is_small(result) ? MaybeRoots(std::move(result)) : std::nullopt;
}

int power_of(const ExactInput& a) {
  return a.exact && a.exact->is_zero() ? 0 : a.pi_power;
}

// The digits of a fraction do not hang on the digits of what it is made of.
ExactInput made(double value, MaybePrecise precise, MaybeRoots exact, int power) {
  ExactInput result(value, std::move(precise), std::move(exact), power);
  if (result.exact && result.exact->is_zero()) {
    result.pi_power = 0;
  }
  if (const std::optional<Rational> fraction = rational_of(result)) {
    result.precise = to_big_float(*fraction);
  }
  return result;
}

MaybeRoots exact_sum(const ExactInput& a, const ExactInput& b) {
  if (!a.exact || !b.exact) {
    return std::nullopt;
  }
  const bool fits = a.pi_power == b.pi_power || a.exact->is_zero() || b.exact->is_zero();
  return fits ? combined(
                    *a.exact, *b.exact, [](const RootSum& x, const RootSum& y) { return x + y; })
              : std::nullopt;
}

// k parts of N = root_count in an angle that is a fraction of pi.
struct Parts {
  int k = 0;
  int root_count = 4;
};

std::optional<Parts> parts_of(const ExactInput& angle) {
  if (!angle.exact) {
    return std::nullopt;
  }
  const bool is_zero_angle = angle.exact->is_zero();
  if (!is_zero_angle && (angle.pi_power != 1 || angle.exact->root_count() != 4 ||
                         !angle.exact->terms().contains(0) || angle.exact->terms().size() != 1)) {
    return std::nullopt;
  }
  const Rational turns = is_zero_angle ? Rational(0) : Rational(angle.exact->terms().at(0) / 2);
  const Rational within = turns - rounded_down(turns);
  const Integer parts = boost::multiprecision::denominator(within);
  if (parts > kMostRoots) {
    return std::nullopt;
  }
  const std::optional<int> count = common_root_count(4, parts.convert_to<int>());
  if (!count) {
    return std::nullopt;
  }
  const Rational k = within * *count;
  return Parts{.k = boost::multiprecision::numerator(k).convert_to<int>(), .root_count = *count};
}

MaybeRoots reduced(RootSum sum) {
  return combined(sum, RootSum(Rational(0), 4), [](const RootSum& x, const RootSum&) { return x; });
}

MaybeRoots exact_sine(const ExactInput& angle) {
  const std::optional<Parts> parts = parts_of(angle);
  return parts ? reduced(RootSum::sine(parts->k, parts->root_count)) : std::nullopt;
}

MaybeRoots exact_cosine(const ExactInput& angle) {
  const std::optional<Parts> parts = parts_of(angle);
  return parts ? reduced(RootSum::cosine(parts->k, parts->root_count)) : std::nullopt;
}

// 2 cos of an eighth of a turn; of an odd prime p the sum of the p-th roots of k² is √p or i √p.
RootSum root_of_prime(int p) {
  if (p == 2) {
    return RootSum(Rational(2), 8) * RootSum::cosine(1, 8);
  }
  const int count = 4 * p;
  RootSum sum(Rational(0), count);
  for (int k = 0; k < p; ++k) {
    const int part = 4 * (k * k % p);
    sum += p % 4 == 1 ? RootSum::cosine(part, count) : RootSum::sine(part, count);
  }
  return sum;
}

MaybeRoots product_of(const RootSum& a, const RootSum& b) {
  return combined(a, b, [](const RootSum& x, const RootSum& y) { return x * y; });
}

MaybeRoots exact_root(const Rational& square) {
  if (square < 0 || !is_within_limit(square)) {
    return std::nullopt;
  }
  const Integer below = boost::multiprecision::denominator(square);
  Integer rest = Integer(boost::multiprecision::numerator(square) * below);
  MaybeRoots result = RootSum(Rational(Rational(1) / Rational(below)), 4);
  for (const int p : std::array{2, 3, 5, 7, 11, 13}) {
    bool is_odd = false;
    while (!rest.is_zero() && rest % p == 0) {
      rest /= p;
      result = is_odd && result ? product_of(*result, RootSum(Rational(p), 4)) : result;
      is_odd = !is_odd;
    }
    result = is_odd && result ? product_of(*result, root_of_prime(p)) : result;
  }
  const std::optional<Rational> whole = exact_square_root(Rational(rest));
  return whole && result ? product_of(*result, RootSum(*whole, 4)) : std::nullopt;
}

MaybeRoots exact_quotient(const ExactInput& a, const ExactInput& b) {
  if (!a.exact || !b.exact || b.exact->is_zero() ||
      totient(b.exact->root_count()) > kLargestInvertedDegree) {
    return std::nullopt;
  }
  return product_of(*a.exact, b.exact->inverse());
}

template <class Function>
MaybePrecise applied(const ExactInput& a, const Function& function) {
  return a.precise ? finite(function(*a.precise)) : std::nullopt;
}

}  // namespace

ExactInput::ExactInput(double number) : value(number) {
  precise = finite(BigFloat(number));
  exact = std::isfinite(number) ? MaybeRoots(RootSum(Rational(number), 4)) : std::nullopt;
}

ExactInput::ExactInput(double number,
                       std::optional<BigFloat> digits,
                       std::optional<RootSum> root_sum,
                       int power)
    : value(number), precise(std::move(digits)), exact(std::move(root_sum)), pi_power(power) {}

std::optional<Rational> rational_of(const ExactInput& number) {
  if (!number.exact || number.pi_power != 0 || number.exact->terms().size() > 1) {
    return std::nullopt;
  }
  if (number.exact->is_zero()) {
    return Rational(0);
  }
  const auto& [k, factor] = *number.exact->terms().begin();
  return k == 0 ? std::optional(factor) : std::nullopt;
}

bool is_zero(const ExactInput& number) {
  return number.exact ? number.exact->is_zero() : number.precise && number.precise->is_zero();
}

ExactInput exact_input_pi() {
  const BigFloat& value = big_float_pi();
  return {static_cast<double>(value), value, RootSum(Rational(1), 4), 1};
}

ExactInput operator-(const ExactInput& a) {
  return {-a.value,
          a.precise ? MaybePrecise(-*a.precise) : std::nullopt,
          a.exact ? MaybeRoots(-*a.exact) : std::nullopt,
          a.pi_power};
}

ExactInput operator+(const ExactInput& a, const ExactInput& b) {
  const bool has_digits = a.precise && b.precise;
  return made(a.value + b.value,
              has_digits ? MaybePrecise(settled_sum(*a.precise, *b.precise)) : std::nullopt,
              exact_sum(a, b),
              a.exact && a.exact->is_zero() ? b.pi_power : a.pi_power);
}

ExactInput operator-(const ExactInput& a, const ExactInput& b) {
  return a + (-b);
}

ExactInput operator*(const ExactInput& a, const ExactInput& b) {
  return made(a.value * b.value,
              a.precise && b.precise ? finite(*a.precise * *b.precise) : std::nullopt,
              a.exact && b.exact ? product_of(*a.exact, *b.exact) : std::nullopt,
              power_of(a) + power_of(b));
}

ExactInput operator/(const ExactInput& a, const ExactInput& b) {
  const bool has_digits = a.precise && b.precise && !b.precise->is_zero();
  return made(a.value / b.value,
              has_digits ? finite(*a.precise / *b.precise) : std::nullopt,
              exact_quotient(a, b),
              power_of(a) - power_of(b));
}

ExactInput sqrt(const ExactInput& a) {
  const std::optional<Rational> fraction = rational_of(a);
  return made(std::sqrt(a.value),
              a.precise && *a.precise >= 0 ? finite(sqrt(*a.precise)) : std::nullopt,
              fraction ? exact_root(*fraction) : std::nullopt,
              0);
}

ExactInput sin(const ExactInput& a) {
  return made(sine(a.value),
              applied(a, [](const BigFloat& x) { return BigFloat(sin(x)); }),
              exact_sine(a),
              0);
}

ExactInput cos(const ExactInput& a) {
  return made(cosine(a.value),
              applied(a, [](const BigFloat& x) { return BigFloat(cos(x)); }),
              exact_cosine(a),
              0);
}

ExactInput tan(const ExactInput& a) {
  ExactInput result = sin(a) / cos(a);
  result.value = tangent(a.value);
  return result;
}

ExactInput atan(const ExactInput& a) {
  return made(std::atan(a.value),
              applied(a, [](const BigFloat& x) { return BigFloat(atan(x)); }),
              a.exact && a.exact->is_zero() ? a.exact : std::nullopt,
              0);
}

ExactInput abs(const ExactInput& a) {
  ExactInput result = a.precise && *a.precise < 0 ? -a : a;
  result.value = std::abs(a.value);
  return result;
}

}  // namespace kinestat
