// The functions of expressions where their values are fractions, or fractions of pi.
#include <utility>

#include "core/contract.hpp"
#include "expression/evaluate/exact_arithmetic.hpp"

namespace kinestat {

namespace {

Rational half() {
  return Rational(1, 2);
}

Rational magnitude(const Rational& a) {
  return a < 0 ? Rational(-a) : a;
}

Rational modulo(const Rational& a, const Rational& b) {
  return Rational(a - b * rounded_down(Rational(a / b)));
}

MaybeExact bare(const std::optional<Rational>& value) {
  return value ? MaybeExact({*value, 0}) : std::nullopt;
}

MaybeExact angle(const std::optional<Rational>& half_turns) {
  return half_turns ? limited({*half_turns, 1}) : std::nullopt;
}

// By Niven's theorem the sine of a rational part of a turn is rational only at multiples of 30
// degrees, and there 0, ±1/2 or ±1.
std::optional<Rational> sine(const Rational& half_turns) {
  const Rational steps = modulo(Rational(half_turns * 6), Rational(12));
  if (steps > 6) {
    const auto mirrored = sine(Rational(half_turns - 1));
    return mirrored ? std::optional(Rational(-*mirrored)) : std::nullopt;
  }
  if (steps == 0 || steps == 6) {
    return Rational(0);
  }
  if (steps == 1 || steps == 5) {
    return half();
  }
  return steps == 3 ? std::optional(Rational(1)) : std::nullopt;
}

std::optional<Rational> tangent(const Rational& half_turns) {
  const Rational steps = modulo(Rational(half_turns * 4), Rational(4));
  if (steps == 0 || steps == 1) {
    return steps;
  }
  return steps == 3 ? std::optional(Rational(-1)) : std::nullopt;
}

// An angle in radians that is no multiple of pi has no rational sine, unless it is zero.
MaybeExact apply_to_angle(Function function, const PiRational& a) {
  using enum Function;
  if (a.pi_power != 1 && !a.factor.is_zero()) {
    return std::nullopt;
  }
  if (function == tan) {
    return bare(tangent(a.factor));
  }
  return bare(sine(function == sin ? a.factor : Rational(a.factor + half())));
}

// In half turns.
std::optional<Rational> arcsine(const Rational& a) {
  if (a < 0) {
    const auto mirrored = arcsine(Rational(-a));
    return mirrored ? std::optional(Rational(-*mirrored)) : std::nullopt;
  }
  if (a == 0) {
    return Rational(0);
  }
  if (a == half()) {
    return Rational(1, 6);
  }
  return a == 1 ? std::optional(half()) : std::nullopt;
}

std::optional<Rational> arccosine(const Rational& a) {
  const auto complement = arcsine(a);
  return complement ? std::optional(Rational(half() - *complement)) : std::nullopt;
}

// In half turns; at the origin 0, as for double. Exact on the axes and half way between them.
std::optional<Rational> angle_of(const Rational& y, const Rational& x) {
  if (y < 0) {
    const auto mirrored = angle_of(Rational(-y), x);
    return mirrored ? std::optional(Rational(-*mirrored)) : std::nullopt;
  }
  if (y == 0) {
    return Rational(x < 0 ? 1 : 0);
  }
  if (x == 0) {
    return half();
  }
  if (y == magnitude(x)) {
    return x > 0 ? Rational(1, 4) : Rational(3, 4);
  }
  return std::nullopt;
}

std::optional<Rational> decimal_logarithm(const Rational& a) {
  if (a <= 0) {
    return std::nullopt;
  }
  const bool is_below_one = a < 1;
  Rational rest = is_below_one ? Rational(1 / a) : a;
  int count = 0;
  for (; is_whole(rest) && rest > 1; ++count) {
    rest /= 10;
  }
  return rest == 1 ? std::optional(Rational(is_below_one ? -count : count)) : std::nullopt;
}

Rational rounded(const Rational& a) {
  return a < 0 ? Rational(-rounded(Rational(-a))) : rounded_down(Rational(a + half()));
}

MaybeExact apply_to_bare(Function function, const Rational& a) {
  using enum Function;
  switch (function) {
    case asin:
      return angle(arcsine(a));
    case acos:
      return angle(arccosine(a));
    case atan:
      return angle(angle_of(a, Rational(1)));
    case exp:
      return a == 0 ? bare(Rational(1)) : std::nullopt;
    case log:
    case ln:
      return a == 1 ? bare(Rational(0)) : std::nullopt;
    case log10:
      return bare(decimal_logarithm(a));
    case floor:
      return bare(rounded_down(a));
    case ceil:
      return bare(Rational(-rounded_down(Rational(-a))));
    default:
      break;
  }
  KINESTAT_EXPECTS(function == round);
  return bare(rounded(a));
}

MaybeExact square_root(const PiRational& a) {
  const auto root = a.pi_power % 2 == 0 ? exact_square_root(a.factor) : std::nullopt;
  return root ? limited({*root, a.pi_power / 2}) : std::nullopt;
}

MaybeExact chosen(Function function, const PiRational& a, const PiRational& b) {
  using enum Function;
  const std::optional<int> order = compare(a, b);
  if (!order) {
    return std::nullopt;
  }
  return (*order < 0) == (function == min) ? a : b;
}

// Both counted in the same power of pi.
MaybeExact apply_to_factors(Function function, const Rational& a, const Rational& b, int pi_power) {
  using enum Function;
  switch (function) {
    case atan2:
      return angle(angle_of(a, b));
    case mod:
      return b == 0 ? std::nullopt : limited({modulo(a, b), pi_power});
    case gcd:
      return pi_power == 0 && is_whole(a) && is_whole(b) ? bare(common_divisor(a, b))
                                                         : std::nullopt;
    default:
      break;
  }
  KINESTAT_EXPECTS(function == hypot);
  return square_root({Rational(a * a + b * b), 2 * pi_power});
}

}  // namespace

MaybeExact apply(Function function, const PiRational& a, const PiRational& b) {
  using enum Function;
  switch (function) {
    case sin:
    case cos:
    case tan:
      return apply_to_angle(function, a);
    case sqrt:
      return square_root(a);
    case abs:
      return PiRational{magnitude(a.factor), a.pi_power};
    case asin:
    case acos:
    case atan:
    case exp:
    case log:
    case ln:
    case log10:
    case floor:
    case ceil:
    case round:
      return a.pi_power == 0 ? apply_to_bare(function, a.factor) : std::nullopt;
    case min:
    case max:
      return chosen(function, a, b);
    case atan2:
    case mod:
    case gcd:
    case hypot:
      break;
  }
  if (a.factor.is_zero() || b.factor.is_zero() || a.pi_power == b.pi_power) {
    return apply_to_factors(
        function, a.factor, b.factor, a.factor.is_zero() ? b.pi_power : a.pi_power);
  }
  return std::nullopt;
}

}  // namespace kinestat
