// Weighted least squares, also where they leave values open.
#pragma once

#include <vector>

#include "core/types.hpp"
#include "math/elimination/rank.hpp"

namespace kinestat {

/// The v = A x + b, for any x, that make Σ (w_i v_i)² least.
struct LeastSquares {
  VecX values;                ///< v; where open, one of many
  std::vector<bool> is_open;  ///< which values the weights do not determine
  RankEvidence evidence;      ///< of the rows of A that have a weight
  MatX measured;  ///< columns that span those of A, together with `open`; with the weights they are
                  ///< well-conditioned
  MatX open;      ///< which the weights do not see
};

/// Weights are not negative; values of weight 0 follow from the others or stay open. The columns of
/// A must be of similar size, say 1. Rows become unknowns, the heaviest first, by elimination
/// (Peters and Wilkinson 1970): what remains for the QR is as well-conditioned with weights of very
/// different size as with equal ones.
LeastSquares find_least_squares(MatX A, VecX b, const VecX& weights);

/// Aᵀ A x = b for any b, by QR of A, whose columns are independent; Aᵀ A is never formed.
class NormalEquations {
 public:
  NormalEquations() = default;

  explicit NormalEquations(const MatX& A);

  VecX solve(VecX b) const;

 private:
  MatX R_;  ///< its upper triangle: Aᵀ A = Rᵀ R
};

}  // namespace kinestat
