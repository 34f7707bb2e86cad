#include "expression/evaluate/precise_operations.hpp"

#include <numeric>
#include <string>

#include "core/contract.hpp"

namespace kinestat {

namespace {

using MaybePrecise = std::optional<BigFloat>;

MaybePrecise finite(MaybePrecise value) {
  return value && isfinite(*value) ? std::move(value) : std::nullopt;
}

// The whole number that `a` may be but for rounding, or `a` itself: 1000 times the cube root of
// 0.001 is 100.
BigFloat settled_whole(const BigFloat& a) {
  const BigFloat nearest = round(a);
  return abs(a - nearest) <= big_float_rounding() * abs(a) ? nearest : a;
}

// A whole exponent multiplies, so that a base below zero has a power.
MaybePrecise raised(const BigFloat& base, const BigFloat& exponent) {
  constexpr int kLargest = 1'000'000;
  if (base == 0) {
    return exponent < 0 ? std::nullopt : MaybePrecise(exponent == 0 ? 1 : 0);
  }
  const BigFloat whole = settled_whole(exponent);
  if (floor(whole) == whole && abs(whole) <= kLargest) {
    return MaybePrecise(pow(base, static_cast<int>(whole)));
  }
  return base < 0 ? std::nullopt : MaybePrecise(pow(base, exponent));
}

// Rounding of the double may have let a value pass that lies beyond the domain by less than that.
MaybePrecise of_sine(Function function, const BigFloat& sine) {
  const BigFloat a = settled_whole(sine);
  if (abs(a) > 1) {
    return std::nullopt;
  }
  return function == Function::asin ? asin(a) : acos(a);
}

MaybePrecise logarithm(Function function, const BigFloat& a) {
  if (a <= 0) {
    return std::nullopt;
  }
  return function == Function::log10 ? log10(a) : log(a);
}

MaybePrecise apply_to_one(Function function, const BigFloat& a) {
  switch (function) {
    case Function::sin:
      return sin(a);
    case Function::cos:
      return cos(a);
    case Function::tan:
      return tan(a);
    case Function::asin:
    case Function::acos:
      return of_sine(function, a);
    case Function::atan:
      return atan(a);
    case Function::sqrt:
      return a < 0 ? std::nullopt : MaybePrecise(sqrt(a));
    case Function::abs:
      return abs(a);
    case Function::exp:
      return exp(a);
    case Function::log:
    case Function::ln:
    case Function::log10:
      return logarithm(function, a);
    case Function::floor:
      return floor(settled_whole(a));
    case Function::ceil:
      return ceil(settled_whole(a));
    default:
      break;
  }
  KINESTAT_EXPECTS(function == Function::round);
  return round(BigFloat(settled_whole(2 * a) / 2));  // halves away from zero
}

MaybePrecise apply_function(Function function, const BigFloat& a, const BigFloat& b) {
  switch (function) {
    case Function::atan2:
      return a == 0 && b == 0 ? BigFloat(0) : atan2(a + 0, b + 0);  // not of a minus zero
    case Function::min:
      return a < b ? a : b;
    case Function::max:
      return a < b ? b : a;
    case Function::mod:
      return b == 0 ? std::nullopt
                    : MaybePrecise(settled_sum(a, -(b * floor(settled_whole(a / b)))));
    case Function::gcd:
      return BigFloat(std::gcd(static_cast<long long>(settled_whole(a)),
                               static_cast<long long>(settled_whole(b))));
    case Function::hypot:
      return sqrt(a * a + b * b);
    default:
      return apply_to_one(function, a);
  }
}

}  // namespace

std::optional<BigFloat> precise_number(std::string_view literal) {
  return finite(BigFloat(std::string(literal)));
}

std::optional<BigFloat> apply_precisely(const Node& operation,
                                        const BigFloat& a,
                                        const BigFloat& b) {
  KINESTAT_EXPECTS(operation.kind == NodeKind::power || operation.kind == NodeKind::function);
  return finite(operation.kind == NodeKind::power ? raised(a, b)
                                                  : apply_function(operation.function, a, b));
}

}  // namespace kinestat
