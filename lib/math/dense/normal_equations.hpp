// The normal equations of a least-squares problem, factored.
#pragma once

#include "core/types.hpp"

namespace kinestat {

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
