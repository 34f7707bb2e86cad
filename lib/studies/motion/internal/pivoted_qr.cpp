#include "studies/motion/internal/pivoted_qr.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/index.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

void PivotedQr::factor(std::span<const double> A, int rows, int columns, double scale) {
  rows_ = rows;
  columns_ = columns;
  rank_ = 0;
  swaps_ = 0;
  row_swaps_ = 0;
  reflections_ = 0;
  has_null_ = false;
  qr_.assign(A.begin(), A.end());
  order_.resize(at(columns));
  std::iota(order_.begin(), order_.end(), 0);
  lengths_.resize(at(columns));
  scale_.resize(at(columns));
  row_.resize(at(columns));
  diagonal_.resize(at(columns));
  work_.resize(at(std::max(rows, columns)));
  const int steps = std::min(rows, columns);
  longest_ = 0.0;
  reciprocal_condition_ = steps == columns ? 1.0 : 0.0;
  for (int step = 0; step < steps; ++step) {
    // Lengths anew at each step: systems are small, and nothing is lost to cancellation.
    int best = step;
    for (int c = step; c < columns; ++c) {
      double sum = 0.0;
      const double* column = qr_.data() + c * rows;
      for (int r = step; r < rows; ++r) {
        sum += column[r] * column[r];
      }
      lengths_[at(c)] = sum;
      if (sum > lengths_[at(best)]) {
        best = c;
      }
    }
    const double length = std::sqrt(lengths_[at(best)]);
    longest_ = step == 0 ? std::max(length, scale) : longest_;
    if (!(length > kRankZero * longest_)) {
      reciprocal_condition_ = step == 0 ? 0.0 : reciprocal_condition_;
      return;
    }
    reciprocal_condition_ = length / longest_;
    if (best != step) {
      std::swap_ranges(
          qr_.begin() + step * rows, qr_.begin() + (step + 1) * rows, qr_.begin() + best * rows);
      std::swap(order_[at(step)], order_[at(best)]);
      ++swaps_;
    }
    swap_rows(step);
    reflect(step);
    ++rank_;
  }
}

// The largest entry of the column comes first: then each row rounds by what is in it (Powell and
// Reid 1969), and rows that share no column with others stay apart from them.
void PivotedQr::swap_rows(int step) {
  const double* v = qr_.data() + step * rows_;
  int largest = step;
  for (int r = step + 1; r < rows_; ++r) {
    if (std::abs(v[r]) > std::abs(v[largest])) {
      largest = r;
    }
  }
  row_[at(step)] = largest;
  if (largest == step) {
    return;
  }
  ++row_swaps_;
  for (int c = step; c < columns_; ++c) {
    std::swap(entry(step, c), entry(largest, c));
  }
}

// Turns what remains of a column onto its first entry; v replaces it below and in that entry.
void PivotedQr::reflect(int step) {
  double* v = qr_.data() + step * rows_;
  double below = 0.0;
  for (int r = step + 1; r < rows_; ++r) {
    below += v[r] * v[r];
  }
  const double head = v[step];
  const double length = std::sqrt(head * head + below);
  if (below == 0.0) {
    diagonal_[at(step)] = head;
    scale_[at(step)] = 0.0;
    return;
  }
  ++reflections_;
  diagonal_[at(step)] = head > 0.0 ? -length : length;
  v[step] = head - diagonal_[at(step)];
  scale_[at(step)] = 2.0 / (v[step] * v[step] + below);
  for (int c = step + 1; c < columns_; ++c) {
    double* column = qr_.data() + c * rows_;
    double sum = 0.0;
    for (int r = step; r < rows_; ++r) {
      sum += v[r] * column[r];
    }
    sum *= scale_[at(step)];
    for (int r = step; r < rows_; ++r) {
      column[r] -= sum * v[r];
    }
  }
}

double PivotedQr::sign() const {
  const double turned = rows_ == columns_ ? turned_sign() : 0.0;
  return (reflections_ + row_swaps_) % 2 == 1 ? -turned : turned;
}

double PivotedQr::turned_sign() const {
  if (rank_ < columns_) {
    return 0.0;
  }
  bool is_negative = swaps_ % 2 == 1;
  for (int i = 0; i < rank_; ++i) {
    is_negative = is_negative != (diagonal_[at(i)] < 0.0);
  }
  return is_negative ? -1.0 : 1.0;
}

double PivotedQr::relative_determinant() const {
  double product = sign();
  for (int i = 0; i < rank_ && product != 0.0; ++i) {
    product *= std::abs(diagonal_[at(i)]) / longest_;
  }
  return product;
}

void PivotedQr::back_substitute(double* x) const {
  for (int i = rank_ - 1; i >= 0; --i) {
    double sum = x[i];
    for (int c = i + 1; c < rank_; ++c) {
      sum -= entry(i, c) * x[c];
    }
    x[i] = sum / diagonal_[at(i)];
  }
}

void PivotedQr::turn(std::span<double> b) const {
  for (int step = 0; step < rank_; ++step) {
    std::swap(b[at(step)], b[at(row_[at(step)])]);
    if (scale_[at(step)] == 0.0) {
      continue;
    }
    const double* v = qr_.data() + step * rows_;
    double sum = 0.0;
    for (int r = step; r < rows_; ++r) {
      sum += v[r] * b[at(r)];
    }
    sum *= scale_[at(step)];
    for (int r = step; r < rows_; ++r) {
      b[at(r)] -= sum * v[r];
    }
  }
}

void PivotedQr::solve(std::span<const double> b, std::span<double> x) {
  std::copy(b.begin(), b.begin() + rows_, work_.begin());
  turn(work_);
  back_substitute(work_.data());
  for (int i = 0; i < columns_; ++i) {
    x[at(order_[at(i)])] = i < rank_ ? work_[at(i)] : 0.0;
  }
  if (rank_ == columns_) {
    return;
  }
  const std::vector<double>& null = null_vectors();
  for (int k = 0; k < columns_ - rank_; ++k) {
    const double* z = null.data() + k * columns_;
    double along = 0.0;
    for (int i = 0; i < columns_; ++i) {
      along += z[i] * x[at(i)];
    }
    for (int i = 0; i < columns_; ++i) {
      x[at(i)] -= along * z[i];
    }
  }
}

const std::vector<double>& PivotedQr::null_vectors() {
  const int count = columns_ - rank_;
  if (has_null_) {
    return null_;
  }
  has_null_ = true;
  null_.assign(at(count * columns_), 0.0);
  std::vector<double> x(at(rank_ + 1));
  for (int k = 0; k < count; ++k) {
    double* z = null_.data() + k * columns_;
    for (int i = 0; i < rank_; ++i) {
      x[at(i)] = -entry(i, rank_ + k);
    }
    back_substitute(x.data());
    for (int i = 0; i < rank_; ++i) {
      z[order_[at(i)]] = x[at(i)];
    }
    z[order_[at(rank_ + k)]] = 1.0;
    // Twice is enough to make them orthonormal.
    for (int again = 0; again < 2; ++again) {
      for (int j = 0; j < k; ++j) {
        const double* y = null_.data() + j * columns_;
        const double along = std::inner_product(z, z + columns_, y, 0.0);
        for (int i = 0; i < columns_; ++i) {
          z[i] -= along * y[i];
        }
      }
    }
    const double length = std::sqrt(std::inner_product(z, z + columns_, z, 0.0));
    std::for_each(z, z + columns_, [length](double& value) { value /= length; });
  }
  return null_;
}

}  // namespace kinestat
