// The statics of a case as the textbook writes it, solved by LAPACK: the unit of benchmarks.
#pragma once

#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "screw/coordinate_basis.hpp"
#include "statics/static_solution.hpp"

namespace kinestat::bench {

/// A_NS ψ_S = -A_NP ψ_P.
class DenseStatics {
 public:
  DenseStatics(const Mechanism& mechanism, const CoordinateBasis& basis, const Case& which);

  Eigen::Index size() const { return A_NS_.rows(); }

  bool is_square() const { return A_NS_.rows() == A_NS_.cols(); }

  /// The copies are part of D: LAPACK overwrites what it is given.
  void copy() {
    A_ = A_NS_;
    x_ = right_;
  }

  /// dgesv, with the copy. Throws std::runtime_error if the matrix is singular.
  void solve();

  /// Whether the passes of the program find the same magnitudes.
  bool agrees(const Topology& topology, const StaticSolution& solution);

 private:
  MatX A_NS_;
  VecX right_;
  std::vector<std::string> names_;
  MatX A_;
  VecX x_;
  std::vector<int> pivots_;
};

}  // namespace kinestat::bench
