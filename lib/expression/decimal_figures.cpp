#include "expression/decimal_figures.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace kinestat {

namespace {

// All that are doubles: 1, 10, …, 1e22.
constexpr auto kExactPowers = [] {
  std::array<double, 23> powers{1.0};
  for (std::size_t i = 1; i < powers.size(); ++i) {
    powers[i] = 10.0 * powers[i - 1];
  }
  return powers;
}();

}  // namespace

double round_to_figures(double number, int figures) {
  constexpr int kLargest = static_cast<int>(kExactPowers.size()) - 1;
  if (number == 0.0 || !std::isfinite(number)) {
    return number;
  }
  const int places = figures - 1 - static_cast<int>(std::floor(std::log10(std::abs(number))));
  if (std::abs(places) > kLargest) {
    return number;
  }
  // A whole number below 1e15 and an exact power: their quotient or product rounds once.
  const double power = kExactPowers[static_cast<std::size_t>(std::abs(places))];
  return places >= 0 ? std::round(number * power) / power : std::round(number / power) * power;
}

}  // namespace kinestat
