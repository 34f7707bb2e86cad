// The equations of one side of a case, motions or actions, factored.
#pragma once

#include <span>
#include <vector>

#include "math/elimination/data_zero.hpp"
#include "mechanism/cases/case.hpp"
#include "studies/sensitivity/internal/change.hpp"

namespace kinestat {

/// Takes magnitudes in SI.
class FactoredSide {
 public:
  /// The system is written in the basis; the magnitudes of the side begin at its `first_column`.
  /// `units` are their SI per unit of the unknown.
  FactoredSide(CoordinateBasis basis,
               SparseMatrix system,
               const std::vector<Primary>& primaries,
               int first_column,
               std::vector<double> units);

  const CoordinateBasis& basis() const { return basis_; }

  /// The magnitudes for a right-hand side; where they are open, one choice of many.
  std::vector<double> solve(const Change& right) const;

  /// For a value that moves by these slopes with the magnitudes.
  AdjointSolution solve_adjoint(const std::vector<double>& slopes) const;

  /// Slopes by the unknowns of the system.
  std::vector<double> scaled(std::vector<double> slopes) const;

  /// How far each equation may be off by what rounding did to the screws in it, the magnitudes
  /// being these.
  VecX row_errors(const std::vector<double>& magnitudes, std::span<const double> rhs = {}) const;

  /// How far these of the magnitudes may be off by that and by the same share of the right-hand
  /// side: row by row of the inverse. Zero for those that are known or open.
  std::vector<double> bounds(std::span<const std::size_t> wanted,
                             const std::vector<double>& magnitudes,
                             std::span<const double> rhs) const;

  /// Whether the redundant equations hold when the right-hand side changes so.
  bool allows(const Change& change) const;

  /// A basis of the magnitudes that stay open.
  std::vector<std::vector<double>> open_magnitudes() const;

 private:
  // What rounding did to screws and loads.
  InexactBlocks blocks() const;
  std::vector<double> right_hand_side(const Change& change) const;
  std::vector<double> magnitudes_of(const VecX& x) const;

  CoordinateBasis basis_;
  SparseMatrix system_;
  Elimination elimination_;
  int first_column_;
  std::vector<double> units_;
};

}  // namespace kinestat
