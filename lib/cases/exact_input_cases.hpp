// Answers from the numbers of a mechanism as typed; these are bound when they are first needed.
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

/// If the request is for exact numbers: adds E0316 for each number that has a value only by
/// rounding, and whatever else is wrong with a number as typed. `mechanism` must be what bind made
/// of the description.
void check_exact_input(const MechanismDescription& description,
                       const Mechanism& mechanism,
                       const AccuracyRequest& request,
                       Diagnostics& found);

/// Answers from the numbers as typed for one mechanism, whose cases are those of the description.
/// Accuracy::automatic uses them only for mechanisms with up to some hundred unknowns.
class ExactInputCases {
 public:
  /// Both must outlive it; `mechanism` must be what bind made of the description.
  ExactInputCases(const MechanismDescription& description,
                  const Mechanism& mechanism,
                  const AccuracyRequest& request)
      : description_(&description), mechanism_(&mechanism), request_(request) {}

  /// Finds what is proved about the rank of the motions, and about that of the actions if wanted.
  /// The numbers as typed are used if the doubles prove nothing, or if the request is for exact
  /// numbers.
  void find_ranks(bool with_actions, Certainty& certainty);

  /// Corrects the counts to the ranks of the numbers as typed, if these are known: if rounding made
  /// a redundant mechanism regular and, for requests of exact numbers, also if a mechanism that is
  /// nearly singular as typed counted as singular once rounded.
  void count_exact_input(const Certainty& certainty, MobilityCounts& counts) const;

  /// Replaces the answer of a case by that of the numbers as typed, if the request or the error
  /// bound of the answer in doubles requires this. Returns true if the doubles have no answer but
  /// the numbers as typed have one. That answer replaces `motion` only if the request is for exact
  /// numbers, because the mechanism is then nearly singular. `known` are the primary motions of the
  /// case, followed by those that it assumes at rest.
  bool improve(std::size_t which, std::span<const Primary> known, KinematicSolution& motion);

  /// The same for the actions of `loaded`, the mechanism with the teeth of `turned` on their coast
  /// flanks. `motion` is that of the case; it may be null or underdetermined.
  bool improve(std::size_t which,
               const Mechanism& loaded,
               const std::vector<int>& turned,
               const KinematicSolution* motion,
               StaticSolution& action);

  /// Improves a solved motion again, once the actions of its case are known.
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
