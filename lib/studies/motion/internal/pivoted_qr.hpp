// Least squares of small dense systems again and again, without allocation.
#pragma once

#include <span>
#include <vector>

#include "core/types.hpp"

namespace kinestat {

/// A P = Q R by Householder reflections, the longest remaining column first, its largest entry in
/// the first row; Q holds these swaps, too. What is shorter than kRankZero of the longest column
/// counts as zero. Buffers grow to the largest system and stay.
class PivotedQr {
 public:
  /// `A` holds rows x columns, one column after the other. Below `scale` the longest column is
  /// short itself.
  void factor(std::span<const double> A, int rows, int columns, double scale = 0.0);

  /// Takes the columns beyond as if they were zero.
  void limit_rank(int most) { rank_ = rank_ < most ? rank_ : most; }

  int rank() const { return rank_; }

  int columns() const { return columns_; }

  /// The shortest column that counted, as share of the longest: how near the rank is to fall.
  double reciprocal_condition() const { return reciprocal_condition_; }

  /// The same where so many columns may be left out: if these are all, there is nothing to fall.
  double reciprocal_condition_beside(int left_out) const {
    return rank_ == 0 && columns_ <= left_out ? 1.0 : reciprocal_condition_;
  }

  /// The sign of the determinant; of a square system of full rank, otherwise 0.
  double sign() const;

  /// The determinant, by the power of the longest column; of a square system, otherwise 0.
  double relative_determinant() const;

  /// The sign of the determinant of Qᵀ A; of full rank, otherwise 0.
  double turned_sign() const;

  /// b becomes Qᵀ b; of its rows those below the rank lie in the range of A.
  void turn(std::span<double> b) const;

  /// The shortest x among those with the least |A x - b|.
  void solve(std::span<const double> b, std::span<double> x);

  /// Orthonormal x with A x = 0, columns() - rank() of them, one after the other.
  const std::vector<double>& null_vectors();

 private:
  double& entry(int row, int column) { return qr_[static_cast<std::size_t>(column * rows_ + row)]; }

  double entry(int row, int column) const {
    return qr_[static_cast<std::size_t>(column * rows_ + row)];
  }

  void swap_rows(int step);
  void reflect(int step);
  void back_substitute(double* x) const;

  int rows_ = 0;
  int columns_ = 0;
  int rank_ = 0;
  int swaps_ = 0;  // of columns
  int row_swaps_ = 0;
  int reflections_ = 0;
  double reciprocal_condition_ = 0.0;
  double longest_ = 0.0;
  bool has_null_ = false;
  std::vector<double> qr_;
  std::vector<double> scale_;     // of each reflection: 2 / |v|²
  std::vector<int> row_;          // of each step: that which was swapped with it
  std::vector<double> diagonal_;  // of R
  std::vector<double> lengths_;   // squared, of what remains of each column
  std::vector<int> order_;
  std::vector<double> work_;
  std::vector<double> null_;
};

}  // namespace kinestat
