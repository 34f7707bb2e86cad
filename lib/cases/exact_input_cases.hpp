// The numbers of a mechanism as typed, bound when somebody first needs them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cases/certainty.hpp"
#include "core/accuracy.hpp"
#include "core/diagnostic.hpp"
#include "kinematics/kinematic_solution.hpp"
#include "mechanism/bind/exact_input_mechanism.hpp"
#include "statics/static_solution.hpp"
#include "studies/mobility/mobility_counts.hpp"

namespace kinestat {

/// Where the request is for exact numbers: E0316 for those that have a value by rounding alone, and
/// what else is wrong with a number as typed. `mechanism` must be what bind made of the
/// description.
void check_exact_input(const MechanismDescription& description,
                       const Mechanism& mechanism,
                       const AccuracyRequest& request,
                       Diagnostics& found);

/// Answers from the numbers as typed for one mechanism, whose cases are those of the description.
/// The automatic way asks for them only in mechanisms of some hundred unknowns.
class ExactInputCases {
 public:
  /// Both must outlive it; `mechanism` must be what bind made of the description.
  ExactInputCases(const MechanismDescription& description,
                  const Mechanism& mechanism,
                  const AccuracyRequest& request)
      : description_(&description), mechanism_(&mechanism), request_(request) {}

  /// Fills in what is proved of the ranks of motions, and of actions if wanted. The numbers as
  /// typed are asked where the doubles prove nothing, or where the request is for exact ones.
  void find_ranks(bool with_actions, Certainty& certainty);

  /// Sets the counts to those of the ranks as typed, as far as these are known: where rounding made
  /// what is redundant regular, and, if the request is for exact numbers, also where what is nearly
  /// singular as typed counts as singular once rounded.
  void count_exact_input(const Certainty& certainty, MobilityCounts& counts) const;

  /// Takes the answer of a case as typed where the request, or the bound of the one in doubles,
  /// asks for it. True if there is one as typed where the doubles have none; it is taken only if
  /// the request is for exact ones: otherwise what is singular once rounded is nearly so as typed.
  /// `known` are the primary motions of the case, with those that it assumes at rest behind them.
  bool improve(std::size_t which, std::span<const Primary> known, KinematicSolution& motion);

  /// Likewise, with the teeth of `turned` on their coast flanks; `motion` is that of the case,
  /// which may leave something open, or null.
  bool improve(std::size_t which,
               const std::vector<int>& turned,
               const KinematicSolution* motion,
               StaticSolution& action);

  /// Asks again for a solved motion, once the actions of its case are known.
  void improve_beside(std::size_t which,
                      std::span<const Primary> known,
                      const StaticSolution& action,
                      KinematicSolution& motion);

 private:
  struct DoubleAnswer;

  const ExactInputMechanism* find();  // null if a number has no value without rounding
  bool is_small() const;
  bool asks_for_exact_input(const RankCertainty& certainty);
  int missing_rank(const std::optional<RankCertainty>& certainty, int counted) const;
  bool is_needed(const DoubleAnswer& of) const;
  std::optional<KinematicSolution> find_better(std::size_t which,
                                               std::span<const Primary> known,
                                               const RankEvidence* beside,
                                               const KinematicSolution& motion);

  const MechanismDescription* description_;
  const Mechanism* mechanism_;
  AccuracyRequest request_;
  bool is_bound_ = false;
  std::optional<ExactInputMechanism> exact_input_;
};

}  // namespace kinestat
