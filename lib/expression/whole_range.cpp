#include "expression/whole_range.hpp"

#include <cmath>

namespace kinestat {

namespace {

constexpr double kLargestWholeNumber = 9007199254740992.0;  // 2^53: up to here doubles are exact

std::optional<double> small_whole(const Rational& value) {
  const double number = to_double(value);
  return is_whole(value) && std::abs(number) <= kLargestWholeNumber ? std::optional(number)
                                                                    : std::nullopt;
}

}  // namespace

std::optional<Rational> exact_count(const Exact& value, const UnitScale& unit) {
  const bool is_fraction =
      value.exact && (value.exact->factor == 0 || value.exact->pi_power == unit.pi_power);
  if (!is_fraction) {
    return std::nullopt;
  }
  return value.exact->factor * Rational(unit.denominator) / Rational(unit.numerator);
}

std::optional<WholeRange> whole_range(const std::optional<Rational>& from,
                                      const std::optional<Rational>& to,
                                      const std::optional<Rational>& step) {
  if (!from || !to || !step) {
    return std::nullopt;
  }
  const Rational a = denominator(*from);
  const Rational b = denominator(*step);
  const Rational common = a * b / common_divisor(a, b);
  const auto first = small_whole(*from * common);
  const auto each = small_whole(*step * common);
  const auto share = small_whole(common);
  const auto last = small_whole(rounded_down((*to - *from) / *step));
  const bool fits = first && each && share && last &&
                    std::abs(*first) + *last * std::abs(*each) <= kLargestWholeNumber;
  return fits ? std::optional(WholeRange{*first, *each, *share, *last}) : std::nullopt;
}

}  // namespace kinestat
