#include "math/dense/linear_programme.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/contract.hpp"
#include "core/tolerance.hpp"

namespace kinestat {

namespace {

constexpr Eigen::Index kMostPivots = 100;  // for each unknown

// A x = b solved for the basic unknowns, one a row; the last row has the reduced costs. Columns:
// the unknowns, one artificial unknown a row, the right-hand side.
class Tableau {
 public:
  Tableau(const MatX& A, const VecX& b) : unknowns_(A.cols()), rows_(A.rows()) {
    table_ = MatX::Zero(rows_ + 1, unknowns_ + rows_ + 1);
    for (Eigen::Index r = 0; r < rows_; ++r) {
      const double sign = b[r] < 0.0 ? -1.0 : 1.0;
      table_.row(r).head(unknowns_) = sign * A.row(r);
      table_(r, unknowns_ + r) = 1.0;
      table_(r, right()) = sign * b[r];
      basic_.push_back(unknowns_ + r);
    }
    least_ = kRankZero * (A.size() == 0 ? 0.0 : A.cwiseAbs().maxCoeff());
  }

  // Whether the artificial unknowns can all be zero; then they are not used any more.
  bool find_start(double largest) {
    table_.row(rows_).setZero();
    for (Eigen::Index r = 0; r < rows_; ++r) {
      table_.row(rows_) -= table_.row(r);
    }
    table_.row(rows_).segment(unknowns_, rows_).setZero();
    least_step_ = kRankZero * largest;
    improve(least_);
    if (std::abs(table_(rows_, right())) > kConsistency * largest) {
      return false;
    }
    for (Eigen::Index r = 0; r < rows_; ++r) {
      for (Eigen::Index c = 0; is_artificial(r) && c < unknowns_; ++c) {
        if (std::abs(table_(r, c)) > least_) {
          pivot(r, c);
        }
      }
    }
    return true;
  }

  void find_least(const VecX& costs) {
    table_.row(rows_).setZero();
    table_.row(rows_).head(unknowns_) = costs.transpose();
    for (Eigen::Index r = 0; r < rows_; ++r) {
      if (!is_artificial(r)) {
        table_.row(rows_) -= costs[basic_[static_cast<std::size_t>(r)]] * table_.row(r);
      }
    }
    improve(kRankZero * costs.cwiseAbs().maxCoeff());
  }

  VecX values() const {
    VecX x = VecX::Zero(unknowns_);
    for (Eigen::Index r = 0; r < rows_; ++r) {
      if (!is_artificial(r)) {
        x[basic_[static_cast<std::size_t>(r)]] = std::max(0.0, table_(r, right()));
      }
    }
    return x;
  }

 private:
  Eigen::Index right() const { return table_.cols() - 1; }

  bool is_artificial(Eigen::Index row) const {
    return basic_[static_cast<std::size_t>(row)] >= unknowns_;
  }

  // The column of largest gain enters, of the rows that allow least the first leaves. A step that
  // gains nothing may be the first of a circle: until one gains again, the first column that helps
  // enters (Bland), which ends every circle. A column that no row holds back would have no lower
  // bound, so that its gain is mere rounding. The number of steps is bounded in case rounding leads
  // in a circle after all.
  void improve(double least_gain) {
    bool is_stuck = false;
    for (Eigen::Index steps = kMostPivots * table_.cols(); steps > 0; --steps) {
      const auto [row, column] = entering(least_gain, is_stuck);
      if (row == rows_) {
        return;
      }
      is_stuck = table_(row, right()) <= least_step_;
      pivot(row, column);
    }
  }

  struct Place {
    Eigen::Index row = 0;
    Eigen::Index column = 0;
  };

  // Row rows_: nothing helps.
  Place entering(double least_gain, bool is_stuck) const {
    Place found{.row = rows_};
    double largest = least_gain;
    for (Eigen::Index c = 0; c < unknowns_; ++c) {
      const Eigen::Index row = -table_(rows_, c) > largest ? leaving_row(c) : rows_;
      if (row == rows_) {
        continue;
      }
      found = {.row = row, .column = c};
      if (is_stuck) {
        break;
      }
      largest = -table_(rows_, c);
    }
    return found;
  }

  Eigen::Index leaving_row(Eigen::Index column) const {
    Eigen::Index best = rows_;
    double least = 0.0;
    for (Eigen::Index r = 0; r < rows_; ++r) {
      if (table_(r, column) <= least_) {
        continue;
      }
      const double ratio = std::max(0.0, table_(r, right())) / table_(r, column);
      const bool is_tie = best < rows_ && ratio == least;
      if (best == rows_ || ratio < least ||
          (is_tie &&
           basic_[static_cast<std::size_t>(r)] < basic_[static_cast<std::size_t>(best)])) {
        best = r;
        least = ratio;
      }
    }
    return best;
  }

  void pivot(Eigen::Index row, Eigen::Index column) {
    table_.row(row) /= table_(row, column);
    for (Eigen::Index r = 0; r <= rows_; ++r) {
      const double factor = table_(r, column);
      if (r != row && factor != 0.0) {
        table_.row(r) -= factor * table_.row(row);
        table_(r, column) = 0.0;
      }
    }
    table_(row, column) = 1.0;
    basic_[static_cast<std::size_t>(row)] = column;
  }

  Eigen::Index unknowns_ = 0;
  Eigen::Index rows_ = 0;
  MatX table_;
  std::vector<Eigen::Index> basic_;  ///< the unknown that each row is solved for
  double least_ = 0.0;               ///< below it an entry is zero
  double least_step_ = 0.0;          ///< below it an unknown that leaves has moved nothing
};

}  // namespace

std::optional<VecX> find_least_cost(const MatX& A, const VecX& b, const VecX& costs) {
  KINESTAT_EXPECTS(A.rows() == b.size() && A.cols() == costs.size());
  KINESTAT_EXPECTS(costs.size() == 0 || costs.minCoeff() >= 0.0);
  const double largest = b.size() == 0 ? 0.0 : b.cwiseAbs().maxCoeff();
  if (costs.size() == 0) {
    return largest == 0.0 ? std::optional(VecX()) : std::nullopt;
  }
  Tableau tableau(A, b);
  if (!tableau.find_start(largest)) {
    return std::nullopt;
  }
  tableau.find_least(costs);
  return tableau.values();
}

}  // namespace kinestat
