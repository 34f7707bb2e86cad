#include "expression/evaluate/precise_carrier.hpp"

#include <numeric>
#include <string>

#include "core/contract.hpp"

namespace kinestat {

namespace {

using MaybePrecise = std::optional<BigFloat>;

BigFloat precise_size_of(const UnitScale& unit) {
  BigFloat size = BigFloat(unit.numerator) / BigFloat(unit.denominator);
  for (int i = 0; i < unit.pi_power; ++i) {
    size *= big_float_pi();
  }
  for (int i = 0; i > unit.pi_power; --i) {
    size /= big_float_pi();
  }
  return size;
}

Precise carrying(MaybePrecise value) {
  const bool is_finite = value && isfinite(*value);
  return {.value = 0.0, .precise = is_finite ? std::move(value) : std::nullopt};
}

MaybePrecise quotient(const BigFloat& a, const BigFloat& b) {
  return b == 0 ? std::nullopt : MaybePrecise(a / b);
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

// Halves away from zero: twice a half is whole.
BigFloat rounded(const BigFloat& a) {
  return round(BigFloat(settled_whole(2 * a) / 2));
}

// The rest of a whole quotient is zero.
BigFloat modulo(const BigFloat& a, const BigFloat& b) {
  return settled_sum(a, -(b * floor(settled_whole(a / b))));
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
  return rounded(a);
}

MaybePrecise apply_function(Function function, const BigFloat& a, const BigFloat& b) {
  switch (function) {
    case Function::atan2:
      return a == 0 && b == 0 ? BigFloat(0) : atan2(a, b);
    case Function::min:
      return a < b ? a : b;
    case Function::max:
      return a < b ? b : a;
    case Function::mod:
      return b == 0 ? std::nullopt : MaybePrecise(modulo(a, b));
    case Function::gcd:
      return BigFloat(std::gcd(static_cast<long long>(settled_whole(a)),
                               static_cast<long long>(settled_whole(b))));
    case Function::hypot:
      return sqrt(a * a + b * b);
    default:
      return apply_to_one(function, a);
  }
}

MaybePrecise apply_to(const Node& operation, const BigFloat& a, const BigFloat& b) {
  switch (operation.kind) {
    case NodeKind::negate:
      return BigFloat(-a);
    case NodeKind::add:
      return settled_sum(a, b);
    case NodeKind::subtract:
      return settled_sum(a, -b);
    case NodeKind::multiply:
      return a * b;
    case NodeKind::divide:
      return quotient(a, b);
    case NodeKind::power:
      return raised(a, b);
    case NodeKind::function:
      return apply_function(operation.function, a, b);
    case NodeKind::number:
    case NodeKind::unit:
    case NodeKind::name:
    case NodeKind::pi:
      break;
  }
  KINESTAT_EXPECTS(operation.kind == NodeKind::function);
  return std::nullopt;
}

}  // namespace

Precise Carrier<Precise>::number(std::string_view literal, double /*value*/) {
  return carrying(BigFloat(std::string(literal)));
}

Precise Carrier<Precise>::pi() {
  return carrying(big_float_pi());
}

Precise Carrier<Precise>::to_si(const Precise& count, const UnitScale& unit) {
  return carrying(count.precise ? MaybePrecise(*count.precise * precise_size_of(unit))
                                : std::nullopt);
}

Precise Carrier<Precise>::from_si(const Precise& value, const UnitScale& unit) {
  return carrying(value.precise ? MaybePrecise(*value.precise / precise_size_of(unit))
                                : std::nullopt);
}

Precise Carrier<Precise>::apply(const Node& operation, const Precise& a, const Precise& b) {
  return carrying(a.precise && b.precise ? apply_to(operation, *a.precise, *b.precise)
                                         : std::nullopt);
}

}  // namespace kinestat
