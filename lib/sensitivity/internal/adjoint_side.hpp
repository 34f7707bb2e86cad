// The equations of one side of a case, motions or actions, ready to be differentiated.
#pragma once

#include <optional>
#include <vector>

#include "mechanism/case.hpp"
#include "sensitivity/internal/change.hpp"

namespace kinestat {

/// The factors of the equations, the unit of each magnitude, and what every parameter changes.
class AdjointSide {
 public:
  /// The magnitudes of the side begin at `first_column` of the system; `units` are their SI per
  /// unit of the unknown, `changes` those of each parameter.
  AdjointSide(SparseMatrix system,
              const std::vector<Primary>& primaries,
              int first_column,
              std::vector<double> units,
              std::vector<Change> changes);

  /// Adds to `result`, one a parameter, the part of a value that moves by dv/dmagnitude with the
  /// magnitudes of this side. A parameter whose change the redundant equations forbid leaves no
  /// value.
  void add(const std::vector<double>& slopes, std::vector<std::optional<Sum>>& result) const;

 private:
  std::vector<double> right_hand_side(const Change& change) const;

  std::size_t row_count_;
  int column_count_;
  Elimination elimination_;
  int first_column_;
  std::vector<double> units_;
  std::vector<Change> changes_;    ///< of each parameter
  std::vector<bool> is_possible_;  ///< likewise
};

}  // namespace kinestat
