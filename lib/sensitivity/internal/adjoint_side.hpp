// One side of a case, motions or actions, with what every parameter changes in it.
#pragma once

#include <optional>
#include <vector>

#include "sensitivity/internal/factored_side.hpp"

namespace kinestat {

/// What parameters change, each in one Change.
struct ParameterChanges {
  std::vector<Change> total;
  /// Of each self-stress of the open actions, what the parameters change under it. Nobody knows its
  /// size, so a value that one of them would move has no derivative.
  std::vector<std::vector<Change>> open;
};

class AdjointSide {
 public:
  AdjointSide(FactoredSide equations, ParameterChanges changes);

  /// Adds to `result`, one a parameter, the part of a value that moves by dv/dmagnitude with the
  /// magnitudes of this side. A parameter whose change the redundant equations forbid, or that
  /// would show a self-stress, leaves no value.
  void add(const std::vector<double>& slopes, std::vector<std::optional<Sum>>& result) const;

 private:
  bool shows_open(const AdjointSolution& adjoint, std::size_t parameter) const;

  FactoredSide equations_;
  ParameterChanges changes_;
  std::vector<bool> is_possible_;  ///< of each parameter
};

}  // namespace kinestat
