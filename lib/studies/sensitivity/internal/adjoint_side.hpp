// One side of a case, motions or actions, with what every parameter changes in it.
#pragma once

#include <optional>
#include <vector>

#include "studies/sensitivity/internal/compatibility.hpp"

namespace kinestat {

class AdjointSide {
 public:
  /// Without `compatibility` nothing completes the equations.
  AdjointSide(FactoredSide equations,
              ParameterChanges changes,
              std::optional<Compatibility> compatibility = std::nullopt);

  /// Adds to `result`, one a parameter, the part of a value that moves by dv/dmagnitude with the
  /// magnitudes of this side. A parameter whose change the redundant equations forbid, or that
  /// would show an open self-stress, leaves no value.
  void add(const std::vector<double>& slopes, std::vector<std::optional<Sum>>& result) const;

  /// Whether the magnitudes have derivatives towards the parameter.
  bool is_possible(std::size_t parameter) const { return changes_.is_possible[parameter]; }

  /// How the magnitudes move with the parameter; empty if it is not possible. Nothing may complete
  /// the equations.
  std::optional<std::vector<double>> slopes_of(std::size_t parameter) const;

 private:
  bool shows_open(const AdjointSolution& adjoint, std::size_t parameter) const;

  FactoredSide equations_;
  ParameterChanges changes_;
  std::optional<Compatibility> compatibility_;
};

}  // namespace kinestat
