// The numbers of a mechanism as typed, bound when somebody first needs them.
#pragma once

#include <optional>

#include "core/accuracy.hpp"
#include "kinematics/kinematic_solution.hpp"
#include "mechanism/typed_mechanism.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Answers from the numbers as typed for one mechanism, whose cases are those of the description.
class TypedNumbers {
 public:
  /// Both must outlive it; `mechanism` must be what bind made of the description.
  TypedNumbers(const MechanismDescription& description,
               const Mechanism& mechanism,
               const AccuracyRequest& request)
      : description_(&description), mechanism_(&mechanism), request_(request) {}

  /// Null if a number has no value without rounding.
  const TypedMechanism* find();

  /// Whether the automatic way may take the time: some hundred unknowns.
  bool is_small() const;

  /// Takes the answer of a case as typed where the request, or the bound of the one in doubles,
  /// asks for it. True if there is one as typed where the doubles have none; it is taken only if
  /// the request is for exact numbers.
  bool improve(std::size_t which, KinematicSolution& motion);

  /// Likewise, with the teeth of `turned` on their other flanks.
  bool improve(std::size_t which, const std::vector<int>& turned, StaticSolution& action);

 private:
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
