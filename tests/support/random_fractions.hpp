// Seeded matrices of fractions.
#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "math/elimination/exact_elimination.hpp"
#include "support/random.hpp"

namespace kinestat {

using Fractions = std::vector<Rational>;

inline ExactMatrix matrix_of(const std::vector<Fractions>& rows) {
  ExactMatrix result{.rows = static_cast<int>(rows.size()),
                     .columns = static_cast<int>(rows.front().size()),
                     .entries = {}};
  for (int r = 0; r < result.rows; ++r) {
    for (int c = 0; c < result.columns; ++c) {
      const Rational& value = rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
      if (!value.is_zero()) {
        result.entries.push_back({.row = r, .column = c, .value = value});
      }
    }
  }
  return result;
}

inline Rational random_fraction(Random& random) {
  const int numerator = random.whole(1, 9);
  return {random.chance(0.5) ? numerator : -numerator, random.whole(1, 9)};
}

/// Of the given rank: the product of a matrix with unit lower and one with unit upper triangle,
/// with about three more entries a column or row, its rows and columns shuffled.
inline ExactMatrix random_matrix(int rows, int columns, int rank, Random& random) {
  std::vector<Fractions> product(static_cast<std::size_t>(rows),
                                 Fractions(static_cast<std::size_t>(columns)));
  std::vector<int> row_places(static_cast<std::size_t>(rows));
  std::vector<int> column_places(static_cast<std::size_t>(columns));
  std::iota(row_places.begin(), row_places.end(), 0);
  std::iota(column_places.begin(), column_places.end(), 0);
  random.shuffle(row_places);
  random.shuffle(column_places);
  for (int k = 0; k < rank; ++k) {
    std::vector<std::pair<int, Rational>> left = {{k, 1}};
    std::vector<std::pair<int, Rational>> right = {{k, 1}};
    for (int i = 0; i < 3; ++i) {
      left.emplace_back(random.whole(k, rows - 1), random_fraction(random));
      right.emplace_back(random.whole(k, columns - 1), random_fraction(random));
      left.back().second *= left.back().first == k ? 0 : 1;
      right.back().second *= right.back().first == k ? 0 : 1;
    }
    for (const auto& [r, a] : left) {
      for (const auto& [c, b] : right) {
        product[static_cast<std::size_t>(row_places[static_cast<std::size_t>(r)])]
               [static_cast<std::size_t>(column_places[static_cast<std::size_t>(c)])] += a * b;
      }
    }
  }
  return matrix_of(product);
}

}  // namespace kinestat
