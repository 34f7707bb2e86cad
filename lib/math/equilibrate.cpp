#include "math/equilibrate.hpp"

#include <algorithm>
#include <cmath>

namespace kinestat {

namespace {

constexpr int kSweeps = 3;

// 2^-e with the largest magnitude in [2^(e-1), 2^e); 1 for a zero or unscalable one.
double inverse_power(double largest) {
  if (!(largest > 0.0) || !std::isfinite(largest)) {
    return 1.0;
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
}

void scale_up(std::vector<double>& factors, const std::vector<double>& largest) {
  for (std::size_t i = 0; i < factors.size(); ++i) {
    factors[i] *= inverse_power(largest[i]);
  }
}

double scaled(const SparseEntry& entry, const Scaling& scaling) {
  return std::abs(entry.value) * scaling.rows[static_cast<std::size_t>(entry.row)] *
         scaling.columns[static_cast<std::size_t>(entry.column)];
}

}  // namespace

Scaling find_scaling(const SparseMatrix& matrix) {
  Scaling scaling{.rows = std::vector<double>(static_cast<std::size_t>(matrix.rows), 1.0),
                  .columns = std::vector<double>(static_cast<std::size_t>(matrix.columns), 1.0)};
  std::vector<double> largest;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    largest.assign(scaling.rows.size(), 0.0);
    for (const SparseEntry& entry : matrix.entries) {
      double& row = largest[static_cast<std::size_t>(entry.row)];
      row = std::max(row, scaled(entry, scaling));
    }
    scale_up(scaling.rows, largest);
    largest.assign(scaling.columns.size(), 0.0);
    for (const SparseEntry& entry : matrix.entries) {
      double& column = largest[static_cast<std::size_t>(entry.column)];
      column = std::max(column, scaled(entry, scaling));
    }
    scale_up(scaling.columns, largest);
  }
  return scaling;
}

}  // namespace kinestat
