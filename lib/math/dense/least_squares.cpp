#include "math/dense/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/QR>

#include "core/contract.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// a - b, and 0 where that is mere rounding.
double difference(double a, double b) {
  const double result = a - b;
  return std::abs(result) <= kCancellation * (std::abs(a) + std::abs(b)) ? 0.0 : result;
}

// Changes the unknowns one by one to values of rows: row p of A becomes a unit vector, b there 0.
class RowUnknowns {
 public:
  RowUnknowns(MatX A, VecX b, const VecX& weights)
      : A_(std::move(A)),
        b_(std::move(b)),
        weights_(weights),
        is_row_used_(static_cast<std::size_t>(A_.rows()), false) {
    evidence_.method = "weighted elimination";
    for (Eigen::Index k = 0; k < A_.cols() && take_next(k); ++k) {
    }
  }

  LeastSquares solve() const {
    const auto rank = static_cast<Eigen::Index>(rows_.size());
    const MatX M = A_.leftCols(rank);
    VecX unit(rank);  // of the unknowns, so that they weigh alike
    for (Eigen::Index k = 0; k < rank; ++k) {
      unit[k] = 1.0 / weights_[rows_[static_cast<std::size_t>(k)]];
    }
    VecX unknowns = VecX::Zero(rank);
    if (rank > 0) {
      const MatX G = weights_.asDiagonal() * M * unit.asDiagonal();
      const VecX right = -weights_.cwiseProduct(b_);
      unknowns = Eigen::ColPivHouseholderQR<MatX>(G).solve(right);
    }
    LeastSquares result{.values = values(M, unit, unknowns),
                        .is_open = {},
                        .evidence = evidence_,
                        .measured = M * unit.asDiagonal(),
                        .open = open_columns(rank)};
    const bool has_open = result.open.cols() > 0;
    for (Eigen::Index r = 0; r < A_.rows(); ++r) {
      result.is_open.push_back(has_open && !result.open.row(r).isZero(0.0));
    }
    return result;
  }

 private:
  struct Place {
    Eigen::Index row = -1;
    Eigen::Index column = -1;
    double weight = 0.0;
  };

  bool counts(Eigen::Index row) const {
    return weights_[row] > 0.0 && !is_row_used_[static_cast<std::size_t>(row)];
  }

  double largest_from(Eigen::Index k) const {
    double largest = 0.0;
    for (Eigen::Index r = 0; r < A_.rows(); ++r) {
      if (counts(r)) {
        largest = std::max(largest, A_.row(r).tail(A_.cols() - k).cwiseAbs().maxCoeff());
      }
    }
    return largest;
  }

  // The heaviest entry among those that are not small.
  Place heaviest_from(Eigen::Index k, double largest) const {
    Place best;
    for (Eigen::Index c = k; c < A_.cols(); ++c) {
      for (Eigen::Index r = 0; r < A_.rows(); ++r) {
        const double size = std::abs(A_(r, c));
        if (counts(r) && size >= kSafePivot * largest && size * weights_[r] > best.weight) {
          best = {.row = r, .column = c, .weight = size * weights_[r]};
        }
      }
    }
    return best;
  }

  bool take_next(Eigen::Index k) {
    const double largest = largest_from(k);
    if (largest <= kRankZero) {
      evidence_.largest_dropped = largest;
      return false;
    }
    const Place place = heaviest_from(k, largest);
    A_.col(k).swap(A_.col(place.column));
    evidence_.smallest_pivot = evidence_.rank == 0
                                   ? std::abs(A_(place.row, k))
                                   : std::min(evidence_.smallest_pivot, std::abs(A_(place.row, k)));
    ++evidence_.rank;
    is_row_used_[static_cast<std::size_t>(place.row)] = true;
    rows_.push_back(place.row);
    eliminate(place.row, k);
    return true;
  }

  void eliminate(Eigen::Index row, Eigen::Index k) {
    A_.col(k) /= A_(row, k);
    A_(row, k) = 1.0;
    for (Eigen::Index c = 0; c < A_.cols(); ++c) {
      if (c != k && A_(row, c) != 0.0) {
        subtract(A_(row, c), k, A_.col(c));
      }
    }
    if (b_[row] != 0.0) {
      subtract(b_[row], k, b_);
    }
  }

  void subtract(double factor, Eigen::Index k, Eigen::Ref<VecX> from) const {
    for (Eigen::Index r = 0; r < A_.rows(); ++r) {
      from[r] = difference(from[r], factor * A_(r, k));
    }
  }

  // A value that is rounding of the unknowns, which are as exact as the largest of them, is zero.
  VecX values(const MatX& M, const VecX& unit, const VecX& unknowns) const {
    const double noise = unknowns.size() == 0 ? 0.0 : unknowns.cwiseAbs().maxCoeff();
    VecX result = b_ + M * unit.cwiseProduct(unknowns);
    const VecX sizes = b_.cwiseAbs() + noise * (M.cwiseAbs() * unit);
    for (Eigen::Index r = 0; r < result.size(); ++r) {
      result[r] = std::abs(result[r]) <= kCancellation * sizes[r] ? 0.0 : result[r];
    }
    return result;
  }

  // Those that found no unknown, without what is rounding in them.
  MatX open_columns(Eigen::Index rank) const {
    MatX open = A_.rightCols(A_.cols() - rank);
    for (Eigen::Index c = 0; c < open.cols(); ++c) {
      const double zero = kRankZero * std::max(1.0, open.col(c).cwiseAbs().maxCoeff());
      open.col(c) = (open.col(c).array().abs() <= zero).select(0.0, open.col(c));
    }
    return open;
  }

  MatX A_;
  VecX b_;
  const VecX& weights_;
  std::vector<bool> is_row_used_;
  std::vector<Eigen::Index> rows_;  // whose values are the unknowns
  RankEvidence evidence_;
};

}  // namespace

LeastSquares find_least_squares(MatX A, VecX b, const VecX& weights) {
  KINESTAT_EXPECTS(A.rows() == b.size() && A.rows() == weights.size());
  return RowUnknowns(std::move(A), std::move(b), weights).solve();
}

NormalEquations::NormalEquations(const MatX& A) {
  KINESTAT_EXPECTS(A.rows() >= A.cols());
  const Eigen::HouseholderQR<MatX> factors(A);
  R_ = factors.matrixQR().topRows(A.cols());
}

VecX NormalEquations::solve(VecX b) const {
  KINESTAT_EXPECTS(b.size() == R_.rows());
  R_.triangularView<Eigen::Upper>().transpose().solveInPlace(b);
  R_.triangularView<Eigen::Upper>().solveInPlace(b);
  return b;
}

}  // namespace kinestat
