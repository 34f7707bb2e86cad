// The functions that random expressions call.
#include <algorithm>
#include <cmath>
#include <utility>

#include "property/expression_meaning.hpp"

namespace kinestat::sample {

namespace {

bool is_near_integer(const Meaning& a) {
  return is_near(a, std::round(a.value));
}

// Long doubles tell sin 30 deg = 1/2 and sin 0 = 0 from their neighbours only for ordinary angles.
bool is_ordinary_angle(const Meaning& a) {
  const long double size = std::abs(a.value);
  return size == 0 || (size > kLoose && size < 1 / kLoose && a.error < kLoose * kLoose);
}

Meaning of_angle(const std::string& name, const Meaning& a) {
  constexpr long double kSlopeRounding = 1e-3L;  // a slope near zero is known no better than others
  if (a.powers != kAngle) {
    return fault(Verdict::dimension);
  }
  const long double tangent = std::tan(a.value);
  if (!is_ordinary_angle(a) || (name == "tan" && std::abs(tangent) > 1e3L)) {
    return fault(Verdict::unclear);
  }
  if (name == "tan") {
    return with_powers(chain(tangent, 1 + tangent * tangent, a), {});
  }
  Meaning result = name == "sin" ? chain(std::sin(a.value), std::cos(a.value), a)
                                 : chain(std::cos(a.value), -std::sin(a.value), a);
  result.error += a.error * a.error;
  for (std::size_t i = 0; i < kVariables.size(); ++i) {
    result.slope_sizes[i] += kSlopeRounding * a.slope_sizes[i];
  }
  return with_powers(result, {});
}

Meaning to_angle(const std::string& name, const Meaning& a) {
  if (name == "atan") {
    return with_powers(chain(std::atan(a.value), 1 / (1 + a.value * a.value), a), kAngle);
  }
  const bool is_at_end = std::abs(std::abs(a.value) - 1) <= a.error / kLoose;
  if (is_at_end && a.error > 0) {
    return fault(Verdict::unclear);
  }
  if (std::abs(a.value) > 1) {
    return fault(Verdict::undefined);
  }
  const long double slope = 1 / std::sqrt((1 - a.value) * (1 + a.value));
  const bool is_kink = std::abs(a.value) > 0.99999L;
  const Meaning result =
      name == "asin" ? chain(std::asin(a.value), slope, a) : chain(std::acos(a.value), -slope, a);
  return not_smooth_if(is_kink, with_powers(result, kAngle));
}

Meaning stepped(const std::string& name, const Meaning& a) {
  const long double shift = name == "round" ? 0.5L : 0;
  const long double at = a.value + shift;
  if (a.error > 0 && std::abs(at - std::round(at)) <= a.error) {
    return fault(Verdict::unclear);
  }
  Meaning result = chain(name == "floor"  ? std::floor(a.value)
                         : name == "ceil" ? std::ceil(a.value)
                                          : std::round(a.value),
                         0,
                         a);
  result.error = 0;
  return result;
}

Meaning of_number(const std::string& name, const Meaning& a) {
  if (!is_bare(a.powers)) {
    return fault(Verdict::dimension);
  }
  if (name == "asin" || name == "acos" || name == "atan") {
    return to_angle(name, a);
  }
  if (name == "exp") {
    return a.value > 100 || a.error > kLoose ? fault(Verdict::unclear)
                                             : chain(std::exp(a.value), std::exp(a.value), a);
  }
  if (name == "floor" || name == "ceil" || name == "round") {
    return stepped(name, a);
  }
  if (is_loose(a)) {
    return fault(Verdict::unclear);
  }
  if (a.value <= 0) {
    return fault(Verdict::undefined);
  }
  return name == "log10" ? chain(std::log10(a.value), 1 / (a.value * std::log(10.0L)), a)
                         : chain(std::log(a.value), 1 / a.value, a);
}

Meaning rooted(const Meaning& a) {
  if (std::ranges::any_of(a.powers, [](int power) { return power % 2 != 0; })) {
    return fault(Verdict::dimension);
  }
  if (is_loose(a)) {
    return fault(Verdict::unclear);
  }
  if (a.value < 0) {
    return fault(Verdict::undefined);
  }
  Powers powers = a.powers;
  std::ranges::for_each(powers, [](int& power) { power /= 2; });
  const long double value = std::sqrt(a.value);
  return not_smooth_if(a.value == 0,
                       with_powers(chain(value, value == 0 ? 0 : 0.5L / value, a), powers));
}

Meaning remainder(const Meaning& a, const Meaning& b) {
  if (is_loose(b)) {
    return fault(Verdict::unclear);
  }
  if (b.value == 0) {
    return fault(Verdict::undefined);
  }
  // What doubles leave of it is rounding there.
  constexpr long double kWhole = 0x1p53L;
  if (std::max({std::abs(a.value), std::abs(b.value), std::abs(a.value / b.value)}) >= kWhole) {
    return fault(Verdict::unclear);
  }
  const Meaning ratio = chain(a.value / b.value, 1 / b.value, a, -a.value / b.value / b.value, b);
  if (ratio.error > 0 && std::abs(ratio.value - std::round(ratio.value)) <= ratio.error) {
    return fault(Verdict::unclear);
  }
  const long double count = std::floor(ratio.value);
  Meaning result = chain(a.value - b.value * count, 1, a, -count, b);
  result.error += result.error == 0 ? 0 : kRounding * std::abs(a.value);
  return result;
}

Meaning common_divisor(const Meaning& a, const Meaning& b) {
  if (!is_bare(a.powers)) {
    return fault(Verdict::dimension);
  }
  if (is_near_integer(a) || is_near_integer(b)) {
    return fault(Verdict::unclear);
  }
  if (!is_integer(a.value) || !is_integer(b.value)) {
    return fault(Verdict::undefined);
  }
  auto x = static_cast<long long>(std::abs(a.value));
  auto y = static_cast<long long>(std::abs(b.value));
  while (y != 0) {
    x = std::exchange(y, x % y);
  }
  return constant(static_cast<long double>(x), {});
}

Meaning chosen(bool is_first, const Meaning& a, const Meaning& b) {
  const bool is_tie = std::abs(a.value - b.value) <= a.error + b.error;
  const bool is_kink = is_tie && (a.error > 0 || b.error > 0 || a.value != b.value);
  const long double share = is_tie ? 0.5L : is_first ? 1 : 0;
  Meaning result = chain(is_first ? a.value : b.value, share, a, 1 - share, b);
  result.error = std::max(a.error, b.error);
  return not_smooth_if(is_kink, result);
}

Meaning of_two(const std::string& name, const Meaning& a, const Meaning& b) {
  if (a.powers != b.powers) {
    return fault(Verdict::dimension);
  }
  if (name == "min" || name == "max") {
    return chosen((a.value < b.value) == (name == "min"), a, b);
  }
  if (name == "mod") {
    return remainder(a, b);
  }
  if (name == "gcd") {
    return common_divisor(a, b);
  }
  const long double r = std::hypot(a.value, b.value);
  if (name == "hypot") {
    const long double divisor = r == 0 ? 1 : r;
    return not_smooth_if(r <= a.error + b.error && a.error + b.error > 0,
                         chain(r, a.value / divisor, a, b.value / divisor, b));
  }
  const bool is_at_cut = is_near(a, 0) && b.value <= b.error;
  if (is_at_cut || (r * kLoose <= a.error + b.error && a.error + b.error > 0)) {
    return fault(Verdict::unclear);
  }
  const Meaning result =
      r == 0 ? chain(0, 0, a, 0, b)
             : chain(std::atan2(a.value + 0, b.value), b.value / r / r, a, -a.value / r / r, b);
  return not_smooth_if(r == 0, with_powers(result, kAngle));
}

}  // namespace

Meaning called(const Tree& tree, const Meaning& a, const Meaning& b) {
  const std::string& name = tree.word;
  if (tree.parts.size() == 2) {
    return of_two(name, a, b);
  }
  if (name == "sin" || name == "cos" || name == "tan") {
    return of_angle(name, a);
  }
  if (name == "sqrt") {
    return rooted(a);
  }
  if (name == "abs") {
    const long double slope = a.value > 0 ? 1 : a.value < 0 ? -1 : 0;
    Meaning result = chain(std::abs(a.value), slope, a);
    result.error = a.error;
    return not_smooth_if(is_near(a, 0), result);
  }
  return of_number(name, a);
}

}  // namespace kinestat::sample
