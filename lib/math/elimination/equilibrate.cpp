#include "math/elimination/equilibrate.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace kinestat {

namespace {

constexpr int kSweeps = 3;
constexpr int kNothing = std::numeric_limits<int>::min();

// The exponent e of a value with magnitude in [2^(e-1), 2^e), read off its bits; less exact for a
// denormal one, whose size is next to nothing.
int exponent_of(double value) {
  constexpr int kBias = 1022;
  return static_cast<int>((std::bit_cast<std::uint64_t>(value) >> 52U) & 0x7ffU) - kBias;
}

double power_of_two(int exponent) {
  constexpr int kBias = 1023;
  const int clamped = std::clamp(exponent, -1000, 1000);
  return std::bit_cast<double>(static_cast<std::uint64_t>(clamped + kBias) << 52U);
}

std::vector<double> powers_of_two(const std::vector<int>& exponents) {
  std::vector<double> powers(exponents.size());
  std::ranges::transform(exponents, powers.begin(), power_of_two);
  return powers;
}

// Shifts each line (row or column) until its largest entry has the exponent 0; whether any moved.
bool shift(std::vector<int>& shifts, const std::vector<int>& largest) {
  bool has_moved = false;
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    if (largest[i] != kNothing && largest[i] != 0) {
      shifts[i] -= largest[i];
      has_moved = true;
    }
  }
  return has_moved;
}

}  // namespace

Scaling find_scaling(const SparseMatrix& matrix) {
  std::vector<int> rows(static_cast<std::size_t>(matrix.rows), 0);
  std::vector<int> columns(static_cast<std::size_t>(matrix.columns), 0);
  std::vector<int> largest;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    largest.assign(rows.size(), kNothing);
    for (const SparseEntry& entry : matrix.entries) {
      const auto row = static_cast<std::size_t>(entry.row);
      const auto column = static_cast<std::size_t>(entry.column);
      largest[row] = std::max(largest[row], exponent_of(entry.value) + rows[row] + columns[column]);
    }
    const bool rows_moved = shift(rows, largest);
    largest.assign(columns.size(), kNothing);
    for (const SparseEntry& entry : matrix.entries) {
      const auto row = static_cast<std::size_t>(entry.row);
      const auto column = static_cast<std::size_t>(entry.column);
      largest[column] =
          std::max(largest[column], exponent_of(entry.value) + rows[row] + columns[column]);
    }
    if (!shift(columns, largest) && !rows_moved) {
      break;
    }
  }
  return {.rows = powers_of_two(rows), .columns = powers_of_two(columns)};
}

}  // namespace kinestat
