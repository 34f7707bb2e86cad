// Which motions are left while rates are prescribed one after the other.
#pragma once

#include <vector>

#include "math/numbers/bounded_number.hpp"
#include "studies/shift/shift_network.hpp"

namespace kinestat {

/// Begins with all motions; each rate that is prescribed takes one away, or follows from those
/// before it. Every sum carries what it may be off by, from the rates of the open train on; what
/// its own bound does not tell from zero is made zero at once, so that it cannot pass for a motion
/// later, when nothing else is left beside it.
class RemainingMotion {
 public:
  explicit RemainingMotion(int motions);

  /// How many motions are left that change no rate prescribed so far.
  int count() const { return static_cast<int>(basis_.size()); }

  /// Whether the rate of this row changes in any motion that is left.
  bool changes(const RateRow& row) const;

  /// Gives the rate of this row a value. Answers false, and changes nothing, if it follows from
  /// those before it.
  bool prescribe(const RateRow& row, double rate);

  /// The rate of this row in the motion that has all rates prescribed and none else.
  BoundedNumber rate(const RateRow& row) const;

 private:
  using Motion = std::vector<BoundedNumber>;  ///< share of each motion at the beginning

  std::vector<Motion> basis_;
  Motion value_;
};

}  // namespace kinestat
