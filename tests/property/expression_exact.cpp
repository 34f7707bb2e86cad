#include "property/expression_exact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace kinestat::sample {

namespace {

using Maybe = std::optional<ExactValue>;

// Values that are fractions for a reason of their own (sin 30 deg = 1/2) are recognised by their
// long double, which no other value comes so near to.
constexpr long double kRecognised = 1e-15L;
constexpr long double kPi = std::numbers::pi_v<long double>;

Maybe fraction(const Fraction& factor, int pi_power = 0) {
  return ExactValue{factor, factor == 0 ? 0 : pi_power};
}

Fraction size_of(const Fraction& a) {
  return a < 0 ? Fraction(-a) : a;
}

Integer divisor_of(Integer a, Integer b) {
  while (b != 0) {
    a = std::exchange(b, Integer(a % b));
  }
  return a < 0 ? Integer(-a) : a;
}

Fraction floor_of(const Fraction& a) {
  const Integer above = numerator(a);
  const Integer below = denominator(a);
  const Integer cut = above / below;  // towards zero
  return Fraction(above < 0 && cut * below != above ? Integer(cut - 1) : cut);
}

Fraction power_of(const Fraction& base, int exponent) {
  Fraction result = 1;
  for (int i = 0; i < std::abs(exponent); ++i) {
    result *= base;
  }
  return exponent < 0 ? Fraction(1 / result) : result;
}

std::optional<Fraction> root_of(const Fraction& a) {
  if (a < 0) {
    return std::nullopt;
  }
  const Integer above = sqrt(Integer(numerator(a)));
  const Integer below = sqrt(Integer(denominator(a)));
  const Fraction root(above, below);
  return root * root == a ? std::optional(root) : std::nullopt;
}

long double value_of(const ExactValue& a) {
  return a.factor.convert_to<long double>() * std::pow(kPi, a.pi_power);
}

Maybe sum(const ExactValue& a, const ExactValue& b, int sign) {
  if (a.factor != 0 && b.factor != 0 && a.pi_power != b.pi_power) {
    return std::nullopt;
  }
  return fraction(a.factor + sign * b.factor, a.factor == 0 ? b.pi_power : a.pi_power);
}

Maybe raised(const ExactValue& a, const ExactValue& b) {
  const bool is_small = b.pi_power == 0 && denominator(b.factor) == 1 && size_of(b.factor) <= 40;
  if (!is_small) {
    return std::nullopt;
  }
  const int exponent = numerator(b.factor).convert_to<int>();
  return fraction(power_of(a.factor, exponent), a.pi_power * exponent);
}

// 0, ±1/2 and ±1 for the sine and cosine of a rational part of a turn; 0 and ±1 for the tangent.
Maybe of_angle(const std::string& name, const ExactValue& a) {
  if (a.factor != 0 && a.pi_power != 1) {
    return std::nullopt;
  }
  // By whole turns nearer to zero, so that the long double keeps its digits.
  const Fraction turns = a.factor / 2;
  const long double angle = 2 * kPi * Fraction(turns - floor_of(turns)).convert_to<long double>();
  const long double value = name == "sin"   ? std::sin(angle)
                            : name == "cos" ? std::cos(angle)
                                            : std::tan(angle);
  const long double step = name == "tan" ? 1 : 2;
  const long double count = std::round(value * step);
  if (std::abs(count) > step || std::abs(value * step - count) > kRecognised) {
    return std::nullopt;
  }
  return fraction(Fraction(static_cast<int>(count), static_cast<int>(step)));
}

// In twelfths of pi, if the angle is a whole number of them and its function is one of the above.
Maybe to_angle(const std::string& name, const Fraction& a) {
  const bool is_special =
      size_of(a) == 1 || a == 0 || (size_of(a) == Fraction(1, 2) && name != "atan");
  if (!is_special) {
    return std::nullopt;
  }
  const auto x = a.convert_to<long double>();
  const long double angle = name == "asin"   ? std::asin(x)
                            : name == "acos" ? std::acos(x)
                                             : std::atan(x);
  return fraction(Fraction(static_cast<int>(std::round(angle * 12 / kPi)), 12), 1);
}

Maybe of_number(const std::string& name, const Fraction& a) {
  if (name == "exp") {
    return a == 0 ? fraction(1) : std::nullopt;
  }
  if (name == "log" || name == "ln") {
    return a == 1 ? fraction(0) : std::nullopt;
  }
  if (name == "log10") {
    const int count = static_cast<int>(std::round(std::log10(a.convert_to<long double>())));
    return power_of(10, count) == a ? fraction(count) : std::nullopt;
  }
  if (name == "floor") {
    return fraction(floor_of(a));
  }
  if (name == "ceil") {
    return fraction(-floor_of(-a));
  }
  if (name == "round") {
    const Fraction size = floor_of(size_of(a) + Fraction(1, 2));
    return fraction(a < 0 ? Fraction(-size) : size);
  }
  return to_angle(name, a);
}

Maybe of_two(const std::string& name, const ExactValue& a, const ExactValue& b) {
  const bool is_same = a.pi_power == b.pi_power || a.factor == 0 || b.factor == 0;
  const bool differs_in_sign = (a.factor < 0) != (b.factor < 0);
  if (name == "min" || name == "max") {
    const bool is_first = (value_of(a) < value_of(b)) == (name == "min");
    const bool is_equal = a.factor == b.factor;
    return is_same || differs_in_sign ? Maybe(is_first && !is_equal ? a : b) : std::nullopt;
  }
  if (!is_same) {
    return std::nullopt;
  }
  const int pi_power = a.factor == 0 ? b.pi_power : a.pi_power;
  if (name == "mod") {
    return fraction(a.factor - b.factor * floor_of(a.factor / b.factor), pi_power);
  }
  if (name == "hypot") {
    const auto root = root_of(a.factor * a.factor + b.factor * b.factor);
    return root ? fraction(*root, pi_power) : std::nullopt;
  }
  if (name == "gcd") {
    return fraction(Fraction(divisor_of(numerator(a.factor), numerator(b.factor))));
  }
  const bool is_special = a.factor == 0 || b.factor == 0 || size_of(a.factor) == size_of(b.factor);
  const long double angle =
      std::atan2(a.factor.convert_to<long double>(), b.factor.convert_to<long double>());
  return is_special ? fraction(Fraction(static_cast<int>(std::round(angle * 4 / kPi)), 4), 1)
                    : std::nullopt;
}

Maybe called(const Tree& tree, const ExactValue& a, const ExactValue& b) {
  const std::string& name = tree.word;
  if (tree.parts.size() == 2) {
    return of_two(name, a, b);
  }
  if (name == "abs") {
    return fraction(size_of(a.factor), a.pi_power);
  }
  if (name == "sqrt") {
    const auto root = a.pi_power % 2 == 0 ? root_of(a.factor) : std::nullopt;
    return root ? fraction(*root, a.pi_power / 2) : std::nullopt;
  }
  if (name == "sin" || name == "cos" || name == "tan") {
    return of_angle(name, a);
  }
  return a.pi_power == 0 ? of_number(name, a.factor) : std::nullopt;
}

Maybe unit_of(const std::string& name) {
  const auto& row = *std::ranges::find(units(), name, [](const UnitRow& u) { return u.name; });
  return fraction(Fraction(row.numerator) / row.denominator, row.pi_power);
}

Maybe parameter_of(const std::string& name) {
  const auto& row = *std::ranges::find(names(), name, [](const NameRow& n) { return n.name; });
  return fraction(Fraction(row.thousandths) / 1000);
}

Maybe value_of_leaf(const Tree& tree) {
  switch (tree.kind) {
    case Kind::unit:
      return unit_of(tree.word);
    case Kind::name:
      return parameter_of(tree.word);
    case Kind::pi:
      return fraction(1, 1);
    default:
      return fraction(Fraction(tree.digits) * power_of(10, -tree.decimals));
  }
}

}  // namespace

std::optional<ExactValue> exact_value(const Tree& tree, std::span<const Meaning> parts) {
  if (parts.empty()) {
    return value_of_leaf(tree);
  }
  if (!parts.front().exact || !parts.back().exact) {
    return std::nullopt;
  }
  const ExactValue& a = *parts.front().exact;
  const ExactValue& b = *parts.back().exact;
  switch (tree.kind) {
    case Kind::negate:
      return fraction(-a.factor, a.pi_power);
    case Kind::add:
      return sum(a, b, 1);
    case Kind::subtract:
      return sum(a, b, -1);
    case Kind::multiply:
      return fraction(a.factor * b.factor, a.pi_power + b.pi_power);
    case Kind::divide:
      return fraction(a.factor / b.factor, a.pi_power - b.pi_power);
    case Kind::power:
      return raised(a, b);
    default:
      return called(tree, a, b);
  }
}

}  // namespace kinestat::sample
