// The meaning of a tree, worked out in long double with the rounding of doubles bounded.
#include "property/expression_meaning.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "property/expression_exact.hpp"

namespace kinestat::sample {

bool is_bare(const Powers& powers) {
  return powers == Powers{};
}

bool is_integer(long double value) {
  return value == std::floor(value) && std::abs(value) < 1e15L;
}

Meaning fault(Verdict verdict) {
  Meaning result;
  result.verdict = verdict;
  return result;
}

bool is_near(const Meaning& a, long double level) {
  return a.error > 0 && std::abs(a.value - level) <= a.error;
}

bool is_loose(const Meaning& a) {
  return a.error > 0 && a.error >= kLoose * std::abs(a.value);
}

Meaning constant(long double value, const Powers& powers) {
  Meaning result;
  result.value = value;
  result.error = is_integer(value) ? 0 : kRounding * std::abs(value);
  result.powers = powers;
  return result;
}

Meaning chain(
    long double value, long double by_a, const Meaning& a, long double by_b, const Meaning& b) {
  Meaning result;
  result.value = value;
  const bool is_exact = a.error == 0 && b.error == 0 && is_integer(a.value) &&
                        is_integer(b.value) && is_integer(value);
  const auto share = [](long double slope, long double size) {
    return size == 0 ? 0.0L : std::abs(slope) * size;
  };
  result.error =
      is_exact ? 0 : share(by_a, a.error) + share(by_b, b.error) + kRounding * std::abs(value);
  result.powers = a.powers;
  for (std::size_t i = 0; i < kVariables.size(); ++i) {
    result.slopes[i] =
        (a.slopes[i] == 0 ? 0 : by_a * a.slopes[i]) + (b.slopes[i] == 0 ? 0 : by_b * b.slopes[i]);
    result.slope_sizes[i] = share(by_a, a.slope_sizes[i]) + share(by_b, b.slope_sizes[i]);
  }
  result.is_smooth = a.is_smooth && b.is_smooth && std::isfinite(by_a) && std::isfinite(by_b);
  return result;
}

Meaning chain(long double value, long double by_a, const Meaning& a) {
  return chain(value, by_a, a, 0, constant(0, {}));
}

Meaning with_powers(Meaning a, const Powers& powers) {
  a.powers = powers;
  return a;
}

Meaning not_smooth_if(bool is_kink, Meaning a) {
  a.is_smooth = a.is_smooth && !is_kink;
  return a;
}

namespace {

constexpr long double kHalfTurn = std::numbers::pi_v<long double>;
constexpr long double kClear = 1e-9L;  // relative errors above this leave slopes uncompared
constexpr long double kLargest = 1e60L;

Meaning multiplied(const Meaning& a, const Meaning& b) {
  Powers powers = a.powers;
  std::ranges::transform(powers, b.powers, powers.begin(), std::plus<>());
  return with_powers(chain(a.value * b.value, b.value, a, a.value, b), powers);
}

Meaning divided(const Meaning& a, const Meaning& b) {
  if (is_loose(b)) {
    return fault(Verdict::unclear);
  }
  if (b.value == 0) {
    return fault(Verdict::undefined);
  }
  Powers powers = a.powers;
  std::ranges::transform(powers, b.powers, powers.begin(), std::minus<>());
  const long double value = a.value / b.value;
  return with_powers(chain(value, 1 / b.value, a, -value / b.value, b), powers);
}

Meaning raised(const Meaning& a, const Meaning& b) {
  if (!is_bare(b.powers)) {
    return fault(Verdict::dimension);
  }
  const bool is_whole = is_integer(b.value);
  if (b.error > 0 && std::abs(b.value - std::round(b.value)) <= b.error + kRounding) {
    return fault(Verdict::unclear);
  }
  if (!is_bare(a.powers) && !(is_whole && std::abs(b.value) <= 1000)) {
    return fault(Verdict::dimension);
  }
  if (is_loose(a)) {
    return fault(Verdict::unclear);
  }
  if ((a.value == 0 && b.value < 0) || (a.value < 0 && !is_whole)) {
    return fault(Verdict::undefined);
  }
  Powers powers{};
  if (!is_bare(a.powers)) {
    std::ranges::transform(
        a.powers, powers.begin(), [&](int power) { return power * static_cast<int>(b.value); });
  }
  const long double value = std::pow(a.value, b.value);
  const long double by_a = b.value == 0 ? 0 : b.value * std::pow(a.value, b.value - 1);
  const long double by_b = a.value > 0 ? value * std::log(a.value) : 0;
  const bool is_kink = a.value <= 0 && (!is_whole || b.slope_sizes[0] + b.slope_sizes[1] > 0);
  return not_smooth_if(is_kink, with_powers(chain(value, by_a, a, by_b, b), powers));
}

Meaning of_unit(const std::string& name) {
  const UnitRow& row = *std::ranges::find(units(), name, [](const UnitRow& u) { return u.name; });
  return constant(row.numerator * std::pow(kHalfTurn, row.pi_power) / row.denominator, row.powers);
}

Meaning of_name(const std::string& name) {
  const auto row = std::ranges::find(names(), name, [](const NameRow& n) { return n.name; });
  Meaning result = constant(row->thousandths / 1000.0L, row->powers);
  const auto variable =
      std::ranges::find(kVariables, static_cast<std::size_t>(row - names().begin()));
  if (variable != kVariables.end()) {
    const auto i = static_cast<std::size_t>(variable - kVariables.begin());
    result.slopes[i] = 1;
    result.slope_sizes[i] = 1;
  }
  return result;
}

Meaning operation(const Tree& tree, const Meaning& a, const Meaning& b) {
  switch (tree.kind) {
    case Kind::negate:
      return chain(-a.value, -1, a);
    case Kind::add:
      return a.powers != b.powers ? fault(Verdict::dimension)
                                  : chain(a.value + b.value, 1, a, 1, b);
    case Kind::subtract:
      return a.powers != b.powers ? fault(Verdict::dimension)
                                  : chain(a.value - b.value, 1, a, -1, b);
    case Kind::multiply:
      return multiplied(a, b);
    case Kind::divide:
      return divided(a, b);
    case Kind::power:
      return raised(a, b);
    default:
      return called(tree, a, b);
  }
}

Meaning meaning_of_leaf(const Tree& tree) {
  switch (tree.kind) {
    case Kind::unit:
      return of_unit(tree.word);
    case Kind::name:
      return of_name(tree.word);
    case Kind::pi:
      return constant(kHalfTurn, {});
    default:
      return constant(tree.digits / std::pow(10.0L, tree.decimals), {});
  }
}

}  // namespace

Meaning meaning_of(const Tree& tree) {
  std::vector<Meaning> parts;
  for (const Tree& part : tree.parts) {
    parts.push_back(meaning_of(part));
    if (parts.back().verdict != Verdict::value) {
      return parts.back();
    }
  }
  Meaning result =
      parts.empty() ? meaning_of_leaf(tree) : operation(tree, parts.front(), parts.back());
  const bool is_extreme = std::abs(result.value) > kLargest ||
                          (result.value != 0 && std::abs(result.value) < 1 / kLargest);
  if (result.verdict == Verdict::value && is_extreme) {
    return fault(Verdict::unclear);
  }
  result.is_smooth = result.is_smooth && result.error <= kClear * std::abs(result.value);
  result.exact = result.verdict == Verdict::value ? exact_value(tree, parts) : std::nullopt;
  return result;
}

}  // namespace kinestat::sample
