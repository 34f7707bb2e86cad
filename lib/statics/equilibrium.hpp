// The equilibrium equations of the bodies, factored once to be solved for many loads.
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

/// Actions that are in equilibrium with the primary actions and the loads.
struct EquilibriumActions {
  VecX magnitudes;         ///< of each action [N·m or N]; one of many if it is undetermined
  double residual = 0.0;   ///< relative
  bool consistent = true;  ///< the redundant equations hold within kConsistency
  AnswerEvidence answer;   ///< of the magnitudes that were asked for
};

/// A tension that is a fixed share of another one, because a cable slips on a pulley between the
/// two segments. The friction that holds back the pulley takes its place as the unknown.
struct TiedTension {
  int action = 0;                 ///< index of the tied tension in Topology::actions
  int to = 0;                     ///< index of the tension to which it is tied; not tied itself
  double share = 0.0;             ///< the tied tension over the other
  double friction_share = 0.0;    ///< the friction force at the rim over the other tension
  std::vector<BodyWrench> pulls;  ///< of 1 N of friction at the rim, on both bodies of the pulley
};

/// The equations A_N ψ + loads = 0, as the equilibrium of the bodies, factored once for a choice of
/// primary actions (Cazangi 2008, sections 3.8.2 and 3.9.2). They can then be solved for any
/// magnitudes of the primaries and any loads. A moved position has a closure error: an action
/// counts as determined if self-stresses change it by no more than this error, and of all
/// magnitudes in equilibrium the least ones are taken.
class Equilibrium {
 public:
  /// `basis` must hold all unit actions and all loads that will be given. `primaries` are indices
  /// of actions, each once; none of them may be tied.
  Equilibrium(const Mechanism& mechanism,
              CoordinateBasis basis,
              std::vector<int> primaries,
              std::vector<TiedTension> ties = {});

  const CoordinateBasis& basis() const { return basis_; }

  const ActionCounts& counts() const { return counts_; }

  const RankEvidence& evidence() const { return elimination_.evidence(); }

  /// Checks the choice of primaries. Loads add constants to the relations between them.
  PrimaryCheck check(std::span<const BodyWrench> loads) const;

  /// The actions for these magnitudes of the primaries [N·m or N], in the order of the constructor.
  EquilibriumActions solve(std::span<const double> known, std::span<const BodyWrench> loads) const;

  /// The same with the digits that `request` asks for; `counts` marks the actions that need them.
  EquilibriumActions solve_to(const AccuracyRequest& request,
                              const std::vector<bool>& counts,
                              std::span<const double> known,
                              std::span<const BodyWrench> loads) const;

  /// Sets to zero the magnitudes of a solution that the closure error of a moved position does not
  /// distinguish from zero. `mechanism` must be that of the constructor.
  void settle(const Mechanism& mechanism,
              std::span<const BodyWrench> loads,
              VecX& magnitudes) const;

  /// The residual of equilibrium for these actions [N·m or N]: the largest sum on a body, relative
  /// to the largest sum of the sizes of its terms.
  double residual(const VecX& magnitudes, std::span<const BodyWrench> loads) const;

  /// A basis of the self-stresses, the actions that are in equilibrium without loads while the
  /// primaries are zero: one vector of magnitudes [N·m or N] per missing primary.
  std::vector<VecX> self_stresses() const;

 private:
  void find_stresses(double closure_error);
  void tie(VecX& per_action) const;

  CoordinateBasis basis_;
  std::vector<int> primaries_;
  std::vector<TiedTension> ties_;
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
