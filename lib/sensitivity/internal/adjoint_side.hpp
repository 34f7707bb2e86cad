// One side of a case, motions or actions, with what every parameter changes in it.
#pragma once

#include <optional>
#include <vector>

#include "sensitivity/internal/factored_side.hpp"

namespace kinestat {

/// What parameters change, each in one Change. Nobody knows the size of a self-stress, so a value
/// that one of them would move has no derivative.
struct ParameterChanges {
  std::vector<Change> total;
  std::vector<bool> is_possible;             ///< whether the change has a size at all
  std::vector<std::vector<double>> open;     ///< magnitudes of each self-stress
  std::vector<std::vector<Change>> by_open;  ///< what the parameters change under it
};

class AdjointSide {
 public:
  AdjointSide(FactoredSide equations, ParameterChanges changes);

  /// Adds to `result`, one a parameter, the part of a value that moves by dv/dmagnitude with the
  /// magnitudes of this side. A parameter whose change the redundant equations forbid, or that
  /// would show a self-stress, leaves no value.
  void add(const std::vector<double>& slopes, std::vector<std::optional<Sum>>& result) const;

  /// Whether the magnitudes have derivatives towards the parameter.
  bool is_possible(std::size_t parameter) const { return changes_.is_possible[parameter]; }

  /// How the magnitudes move with the parameter; empty if it is not possible.
  std::optional<std::vector<double>> slopes_of(std::size_t parameter) const;

 private:
  bool shows_open(const AdjointSolution& adjoint, std::size_t parameter) const;

  FactoredSide equations_;
  ParameterChanges changes_;
};

}  // namespace kinestat
