// The numbers of a mechanism as typed, bound when somebody first needs them.
#pragma once

#include <optional>

#include "core/accuracy.hpp"
#include "kinematics/kinematic_solution.hpp"
#include "mechanism/typed_mechanism.hpp"
#include "report/certainty.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Answers from the numbers as typed for one mechanism, whose cases are those of the description.
/// The automatic way asks for them only in mechanisms of some hundred unknowns.
class TypedNumbers {
 public:
  /// Both must outlive it; `mechanism` must be what bind made of the description.
  TypedNumbers(const MechanismDescription& description,
               const Mechanism& mechanism,
               const AccuracyRequest& request)
      : description_(&description), mechanism_(&mechanism), request_(request) {}

  /// Fills in what is proved of the ranks of motions, and of actions if wanted. The numbers as
  /// typed are asked where the doubles prove nothing, or where the request is for exact ones.
  void find_ranks(bool with_actions, Certainty& certainty);

  /// Takes the answer of a case as typed where the request, or the bound of the one in doubles,
  /// asks for it. True if there is one as typed where the doubles have none; it is taken only if
  /// the request is for exact numbers.
  bool improve(std::size_t which, KinematicSolution& motion);

  /// Likewise, with the teeth of `turned` on their other flanks.
  bool improve(std::size_t which, const std::vector<int>& turned, StaticSolution& action);

 private:
  const TypedMechanism* find();  // null if a number has no value without rounding
  bool is_small() const;
  bool asks_for_typed(const RankCertainty& certainty);
  bool is_needed(SolveStatus status,
                 const AnswerEvidence& answer,
                 const RankEvidence& evidence) const;

  const MechanismDescription* description_;
  const Mechanism* mechanism_;
  AccuracyRequest request_;
  bool is_bound_ = false;
  std::optional<TypedMechanism> typed_;
};

}  // namespace kinestat
