#include "shift/internal/remaining_motion.hpp"

#include <cmath>
#include <utility>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// A sum of products, and the sum of their sizes, against which it may be rounding.
struct Product {
  double value = 0.0;
  double size = 0.0;
};

Product product(const Eigen::Ref<const Eigen::RowVectorXd>& row,
                const Eigen::Ref<const VecX>& column) {
  Product result;
  for (Eigen::Index i = 0; i < row.size(); ++i) {
    const double term = row[i] * column[i];
    result.value += term;
    result.size += std::abs(term);
  }
  return result;
}

bool counts(const Product& one) {
  return std::abs(one.value) > kRankZero * one.size;
}

}  // namespace

Eigen::Index RemainingMotion::strongest(const Eigen::Ref<const Eigen::RowVectorXd>& row) const {
  Eigen::Index best = -1;
  double most = 0.0;
  for (Eigen::Index j = 0; j < basis_.cols(); ++j) {
    const Product change = product(row, basis_.col(j));
    if (counts(change) && std::abs(change.value) > most) {
      most = std::abs(change.value);
      best = j;
    }
  }
  return best;
}

bool RemainingMotion::changes(const Eigen::Ref<const Eigen::RowVectorXd>& row) const {
  return strongest(row) >= 0;
}

// The motion that changes the rate most brings it to its value and takes its change out of the
// others; multipliers are at most 1.
bool RemainingMotion::prescribe(const Eigen::Ref<const Eigen::RowVectorXd>& row, double rate) {
  const Eigen::Index pivot = strongest(row);
  if (pivot < 0) {
    return false;
  }
  const VecX motion = basis_.col(pivot) / product(row, basis_.col(pivot)).value;
  value_ += (rate - product(row, value_).value) * motion;
  MatX rest(basis_.rows(), basis_.cols() - 1);
  for (Eigen::Index j = 0; j < basis_.cols(); ++j) {
    if (j != pivot) {
      const double change = product(row, basis_.col(j)).value;
      const VecX before = basis_.col(j);
      VecX after = before - change * motion;
      for (Eigen::Index i = 0; i < after.size(); ++i) {
        const double size = std::abs(before[i]) + std::abs(change * motion[i]);
        after[i] = std::abs(after[i]) <= kCancellation * size ? 0.0 : after[i];
      }
      rest.col(j < pivot ? j : j - 1) = after;
    }
  }
  basis_ = std::move(rest);
  return true;
}

double RemainingMotion::rate(const Eigen::Ref<const Eigen::RowVectorXd>& row) const {
  const Product result = product(row, value_);
  return counts(result) ? result.value : 0.0;
}

}  // namespace kinestat
