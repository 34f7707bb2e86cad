// The equations by which stiffness or the least norm completes equilibrium, and their adjoint.
#pragma once

#include <vector>

#include "math/dense/least_squares.hpp"
#include "studies/sensitivity/internal/factored_side.hpp"

namespace kinestat {

/// Nᵀ C ψ = 0: the elongations C ψ of all actions ψ fit together, so that no self-stress in the
/// columns of N does work on them (Castigliano, Menabrea). C holds the compliances; for the least
/// norm, one by the square of what it divides by.
///
/// With w = (Nᵀ C N)⁻¹ Nᵀ g, a value with the slopes g towards ψ moves by
///   (g - C N w)·dψ - (N w)·dC ψ + λ·dA N w,   C ψ = Aᵀ λ.
/// Here dψ are any actions that keep the equilibrium A ψ = b: the first part is an adjoint of it.
/// The rest is what each parameter opens between the elongations, times w.
class Compatibility {
 public:
  /// `magnitudes` are ψ; the columns of N are the completed self-stresses of `changes`. C does not
  /// see the others.
  Compatibility(const DualCase& values,
                const FactoredSide& equations,
                const std::vector<double>& magnitudes,
                const ParameterChanges& changes);

  /// w of a value, of which `slopes` are g.
  VecX shares(const std::vector<double>& slopes) const;

  /// g - C N w.
  std::vector<double> remaining(const std::vector<double>& slopes, const VecX& shares) const;

  /// Whether the value has a derivative towards the parameter, as far as self-stresses move it. Not
  /// if one of these is lost as soon as the parameter moves, or if elongations that do not fit
  /// begin to stress what was rigid.
  bool allows(const VecX& shares, std::size_t parameter) const;

  /// Adds the part of the derivative that is not an adjoint of the equilibrium.
  void add(const VecX& shares, std::size_t parameter, Sum& sum) const;

 private:
  std::vector<std::vector<double>> stresses_;  ///< the columns of N
  std::vector<double> compliances_;            ///< of each action
  NormalEquations equations_;                  ///< Nᵀ C N
  std::vector<std::vector<Sum>> gaps_;         ///< of each self-stress: by each parameter
  std::vector<std::vector<bool>> is_lost_;     ///< likewise: whether it is one only here
  std::vector<bool> is_stressed_;              ///< of each parameter: what was rigid
};

}  // namespace kinestat
