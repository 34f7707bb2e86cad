// Equilibrium in which frictions act, factored once for all of them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "statics/equilibrium.hpp"
#include "statics/friction_law.hpp"
#include "statics/internal/friction_function.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// A choice among the laws of a system: indices, ascending, and the magnitude of each.
struct ChosenFrictions {
  std::vector<std::size_t> laws;
  VecX magnitudes;  ///< [N·m or N]
};

/// Actions are affine in the magnitudes of the frictions: ψ = ψ_0 + Σ f_i ψ_i. What a unit of each
/// brings along may be given. The mechanism, the loads and the laws must outlive it; the case
/// without friction must have an answer.
class FrictionSystem {
 public:
  FrictionSystem(const Mechanism& mechanism,
                 const CoordinateBasis& basis,
                 std::span<const Primary> primaries,
                 std::span<const BodyWrench> loads,
                 std::span<const FrictionLaw> laws,
                 const std::vector<TiedTension>& ties = {},
                 std::span<const std::vector<BodyWrench>> along = {});

  /// Of the actions that equilibrium leaves open by itself, as `find_open` asks for them.
  std::vector<int> undetermined() const { return equilibrium_.check(loads_).undetermined; }

  const FrictionLaw& law(std::size_t i) const { return laws_[i]; }

  /// Gives the known actions other magnitudes, in the order of the primaries.
  void set_primaries(std::span<const double> values);

  /// ψ_0.
  const VecX& frictionless() const { return frictionless_; }

  /// ψ_i.
  const VecX& response(std::size_t i) const;

  /// Finds which laws need an action that equilibrium leaves open; these open all actions that
  /// their friction moves, so that other laws may follow.
  void find_open(std::vector<int> undetermined);

  bool is_open(std::size_t i) const { return is_open_[i]; }

  /// Of one part of a law: its pressing force as a function of the frictions of the chosen laws.
  FrictionFunction function_of(std::size_t i, const std::vector<std::size_t>& chosen) const;

  /// What presses in a part of a law, under these actions.
  Vec3 pressing_of(std::size_t law, std::size_t part, const VecX& actions) const;

  /// ψ with these frictions.
  VecX actions_with(const ChosenFrictions& frictions) const;

  /// The whole solution with these frictions.
  StaticSolution solution_with(const ChosenFrictions& frictions) const;

 private:
  Vec3 slope(std::size_t law, std::size_t part, std::size_t friction) const;
  std::vector<BodyWrench> pair_of(const FrictionLaw& law, double magnitude) const;
  Vec3 pressing_force(const PressingPart& part,
                      const FrictionLaw& law,
                      const VecX& magnitudes) const;
  bool needs_open_action(const FrictionLaw& law) const;
  void leave_open(StaticSolution& solution) const;
  void add_friction(const ChosenFrictions& frictions, StaticSolution& solution) const;
  void add_ignored(StaticSolution& solution) const;

  const Mechanism& mechanism_;
  std::span<const Primary> primaries_;
  std::span<const BodyWrench> loads_;
  std::span<const FrictionLaw> laws_;
  std::vector<TiedTension> ties_;
  std::span<const std::vector<BodyWrench>> along_;  ///< of each law, or none at all
  Equilibrium equilibrium_;
  VecX frictionless_;
  std::vector<VecX> of_primaries_;  ///< for a magnitude of 1 each; once others are set
  VecX of_loads_;                   ///< likewise
  mutable std::vector<std::optional<VecX>> responses_;  ///< solved when first asked for
  /// Of each law, part and friction: what presses for a magnitude of 1; found when first asked for.
  mutable std::vector<std::vector<std::vector<std::optional<Vec3>>>> slopes_;
  std::vector<bool> is_open_;
  std::vector<int> open_actions_;  ///< ascending
};

}  // namespace kinestat
