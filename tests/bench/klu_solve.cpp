#include "klu_solve.hpp"

#include <algorithm>
#include <cmath>
#include <klu.h>
#include <stdexcept>
#include <utility>

namespace kinestat::bench {

KluSolve::KluSolve(const SparseMatrix& matrix,
                   std::span<const int> known,
                   std::span<const double> values)
    : right_(static_cast<std::size_t>(matrix.rows), 0.0) {
  std::vector<std::vector<std::pair<int, double>>> of_column(
      static_cast<std::size_t>(matrix.columns));
  for (const SparseEntry& entry : matrix.entries) {
    of_column[static_cast<std::size_t>(entry.column)].emplace_back(entry.row, entry.value);
  }
  for (std::size_t i = 0; i < known.size(); ++i) {
    for (const auto& [row, value] : of_column[static_cast<std::size_t>(known[i])]) {
      right_[static_cast<std::size_t>(row)] -= values[i] * value;
    }
  }
  for (int c = 0; c < matrix.columns; ++c) {
    if (std::ranges::find(known, c) != known.end()) {
      continue;
    }
    columns_.push_back(c);
    starts_.push_back(static_cast<int>(rows_.size()));
    auto& entries = of_column[static_cast<std::size_t>(c)];
    std::ranges::sort(entries);
    for (const auto& [row, value] : entries) {
      if (static_cast<int>(rows_.size()) > starts_.back() && rows_.back() == row) {
        values_.back() += value;
      } else {
        rows_.push_back(row);
        values_.push_back(value);
      }
    }
  }
  starts_.push_back(static_cast<int>(rows_.size()));
  if (columns_.size() != right_.size()) {
    throw std::runtime_error("the system for KLU is not square");
  }
}

void KluSolve::solve() {
  klu_common common;
  klu_defaults(&common);
  const int n = static_cast<int>(columns_.size());
  klu_symbolic* symbolic = klu_analyze(n, starts_.data(), rows_.data(), &common);
  klu_numeric* numeric =
      symbolic == nullptr
          ? nullptr
          : klu_factor(starts_.data(), rows_.data(), values_.data(), symbolic, &common);
  x_ = right_;
  const bool is_solved =
      numeric != nullptr && klu_solve(symbolic, numeric, n, 1, x_.data(), &common) == 1;
  klu_free_numeric(&numeric, &common);
  klu_free_symbolic(&symbolic, &common);
  if (!is_solved) {
    throw std::runtime_error("KLU cannot solve the system");
  }
}

double KluSolve::difference(const VecX& x) const {
  double largest = 0.0;
  double difference = 0.0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    largest = std::max(largest, std::abs(x_[i]));
    difference = std::max(difference, std::abs(x_[i] - x[columns_[i]]));
  }
  return difference / largest;
}

}  // namespace kinestat::bench
