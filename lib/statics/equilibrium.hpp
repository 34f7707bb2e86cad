// The equilibrium of the bodies, factored.
#pragma once

#include <span>
#include <vector>

#include "core/accuracy.hpp"
#include "math/elimination/data_zero.hpp"
#include "mechanism/mechanism.hpp"
#include "network/freedom_counts.hpp"
#include "network/primary_check.hpp"
#include "screw/coordinate_basis.hpp"

namespace kinestat {

/// Actions that are in equilibrium with known ones and with loads.
struct EquilibriumActions {
  VecX magnitudes;         ///< of each action [N·m or N]; where undetermined, one choice of many
  double residual = 0.0;   ///< relative
  bool consistent = true;  ///< the equations that are surplus hold within kConsistency
  AnswerEvidence answer;   ///< of those magnitudes that were asked for
};

/// A tension that is a fixed share of another one, because a cable slips between them. The friction
/// that holds the pulley back is unknown in its place.
struct SlippingCableTension {
  int action = 0;
  int to = 0;                     ///< is no tied action itself
  double share = 0.0;             ///< of that tension: this one
  double friction_share = 0.0;    ///< of that tension: the friction as a force at the rim
  std::vector<BodyWrench> pulls;  ///< on both bodies of the pulley, of 1 N at the rim
};

/// A_N ψ + loads = 0 as the equilibrium of the bodies, factored once for a choice of primary
/// actions (Cazangi 2008, sections 3.8.2 and 3.9.2). It answers for any magnitudes of them and any
/// loads, those that depend on the answer among them. In a moved position an action is determined
/// if self-stresses move it by no more than that misses closure, and magnitudes are the least ones.
class Equilibrium {
 public:
  /// `basis` must hold all unit actions and the loads to come; `primaries` are actions, each once,
  /// and not tied.
  Equilibrium(const Mechanism& mechanism,
              CoordinateBasis basis,
              std::vector<int> primaries,
              std::vector<SlippingCableTension> ties = {});

  const CoordinateBasis& basis() const { return basis_; }

  const ActionCounts& counts() const { return counts_; }

  const RankEvidence& evidence() const { return elimination_.evidence(); }

  /// Whether the primaries are right; loads add constants to the relations between them.
  PrimaryCheck check(std::span<const BodyWrench> loads) const;

  /// The actions for magnitudes of the primaries [N·m or N], in the order of their choice.
  EquilibriumActions solve(std::span<const double> known, std::span<const BodyWrench> loads) const;

  /// The same with as many digits as asked for of the actions that `counts`.
  EquilibriumActions solve_to(const AccuracyRequest& request,
                              const std::vector<bool>& counts,
                              std::span<const double> known,
                              std::span<const BodyWrench> loads) const;

  /// Makes those of its solution zero that a moved position does not tell from zero, for all that
  /// it misses closure. `mechanism` is the one that it was made of.
  void settle(const Mechanism& mechanism,
              std::span<const BodyWrench> loads,
              VecX& magnitudes) const;

  /// How well the actions [N·m or N] are in equilibrium with the loads: the largest sum on a body
  /// relative to the largest sum of sizes.
  double residual(const VecX& magnitudes, std::span<const BodyWrench> loads) const;

  /// A basis of the actions that are in equilibrium with each other alone, the primaries being
  /// zero: one vector of magnitudes [N·m or N] a missing primary.
  std::vector<VecX> self_stresses() const;

 private:
  void find_stresses(double closure_error);
  void tie(VecX& per_action) const;

  CoordinateBasis basis_;
  std::vector<int> primaries_;
  std::vector<SlippingCableTension> ties_;
  std::vector<int> driving_;   ///< actions of actuators
  std::vector<double> sizes_;  ///< of what each action may become, a tension being 1: see ties
  std::vector<double> units_;  ///< SI per unit of the unknown of each action
  int body_count_ = 0;
  Elimination elimination_;
  ActionCounts counts_;
  InexactBlocks blocks_;   ///< how far off its numbers are by rounding and closure
  bool is_moved_ = false;  ///< and has self-stresses
  MatX stresses_;          ///< then: an orthonormal basis of them in units, one a column
  std::vector<int> open_;  ///< then: the actions that they move, ascending
};

}  // namespace kinestat
