#include "expression/decimal_figures.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>

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

constexpr int kMostExactPower = static_cast<int>(kExactPowers.size()) - 1;

double exact_power(int exponent) {
  return kExactPowers[static_cast<std::size_t>(exponent)];
}

// The largest power of ten that is not above a size from 1e-22 to 1e22. From its power of two,
// 1233 / 4096 being the logarithm of two: one too few at the most.
int decimal_exponent(double size) {
  const int next = ((std::ilogb(size) * 1233) >> 12) + 1;
  const bool is_reached = next >= 0 ? size >= exact_power(next) : size * exact_power(-next) >= 1.0;
  return is_reached ? next : next - 1;
}

}  // namespace

double round_to_figures(double number, int figures) {
  const double size = std::abs(number);
  if (!(size >= 1.0 / exact_power(kMostExactPower) && size < exact_power(kMostExactPower - 1))) {
    return number;
  }
  const int places = figures - 1 - decimal_exponent(size);
  if (places > kMostExactPower) {
    return number;
  }
  // A whole number below 1e15 and an exact power: their quotient or product rounds once.
  const double power = exact_power(std::abs(places));
  return places >= 0 ? std::round(number * power) / power : std::round(number / power) * power;
}

}  // namespace kinestat
