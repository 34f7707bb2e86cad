// Which motions are left while rates are prescribed one after the other.
#pragma once

#include "core/types.hpp"

namespace kinestat {

/// Begins with all motions; each rate that is prescribed takes one away, or follows from those
/// before it.
class RemainingMotion {
 public:
  explicit RemainingMotion(Eigen::Index motions)
      : basis_(MatX::Identity(motions, motions)), value_(VecX::Zero(motions)) {}

  /// How many motions are left that change no rate prescribed so far.
  int count() const { return static_cast<int>(basis_.cols()); }

  /// Their combinations of the motions at the beginning, one column each.
  const MatX& basis() const { return basis_; }

  /// Whether the rate of this row changes in any motion that is left.
  bool changes(const Eigen::Ref<const Eigen::RowVectorXd>& row) const;

  /// Gives the rate of this row a value. Answers false, and changes nothing, if it follows from
  /// those before it.
  bool prescribe(const Eigen::Ref<const Eigen::RowVectorXd>& row, double rate);

  /// The rate of this row in the motion that has all rates prescribed and none else; zero where it
  /// is but rounding.
  double rate(const Eigen::Ref<const Eigen::RowVectorXd>& row) const;

 private:
  // The column in which the row changes most, or -1 if all changes are rounding.
  Eigen::Index strongest(const Eigen::Ref<const Eigen::RowVectorXd>& row) const;

  MatX basis_;
  VecX value_;
};

}  // namespace kinestat
