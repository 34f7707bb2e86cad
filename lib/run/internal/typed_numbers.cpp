#include "run/internal/typed_numbers.hpp"

#include <cmath>
#include <utility>

#include "core/tolerance.hpp"
#include "kinematics/typed_velocity.hpp"
#include "statics/typed_action.hpp"

namespace kinestat {

namespace {

constexpr int kMostMagnitudes = 500;

}  // namespace

const TypedMechanism* TypedNumbers::find() {
  if (!is_bound_) {
    typed_ = bind_typed(*description_, *mechanism_);
    is_bound_ = true;
  }
  return typed_ ? &*typed_ : nullptr;
}

bool TypedNumbers::is_small() const {
  const Topology& topology = mechanism_->topology;
  return topology.freedom_count() + topology.action_count() <= kMostMagnitudes;
}

// A pivot this small, or places this far away, may have lost the digits asked for when the numbers
// were rounded to double.
bool TypedNumbers::is_needed(SolveStatus status,
                             const AnswerEvidence& answer,
                             const RankEvidence& evidence) const {
  const bool can_improve = status == SolveStatus::solved || status == SolveStatus::dependent ||
                           status == SolveStatus::underdetermined ||
                           status == SolveStatus::inconsistent;
  if (!can_improve) {
    return false;
  }
  const Geometry& geometry = mechanism_->geometry;
  const double distance = 1.0 + geometry.origin.norm() / geometry.length;
  const double lost = kCancellation * distance / evidence.smallest_pivot;
  const bool is_sure = status == SolveStatus::solved && reaches(answer, request_.digits) &&
                       lost <= std::pow(10.0, -request_.digits);
  switch (request_.accuracy) {
    case Accuracy::fast:
    case Accuracy::high:
      return false;
    case Accuracy::automatic:
      return !is_sure && is_small();
    case Accuracy::exact:
      return true;
  }
  return false;
}

bool TypedNumbers::asks_for_typed(const RankCertainty& certainty) {
  const bool is_wanted = request_.accuracy == Accuracy::exact;
  return (is_wanted || (certainty.how != "structural" && is_small())) && find() != nullptr;
}

void TypedNumbers::find_ranks(bool with_actions, Certainty& certainty) {
  certainty.motion_rank = find_motion_certainty(*mechanism_);
  if (asks_for_typed(*certainty.motion_rank)) {
    add_typed_motions(*mechanism_, *typed_, *certainty.motion_rank);
  }
  if (!with_actions) {
    return;
  }
  certainty.action_rank = find_action_certainty(*mechanism_);
  if (asks_for_typed(*certainty.action_rank)) {
    add_typed_actions(*mechanism_, *typed_, *certainty.action_rank);
  }
}

bool TypedNumbers::improve(std::size_t which, KinematicSolution& motion) {
  if (!is_needed(motion.status, motion.answer, motion.evidence) || find() == nullptr) {
    return false;
  }
  auto better = solve_velocity_as_typed(*mechanism_,
                                        typed_->motions,
                                        mechanism_->cases[which].motions,
                                        typed_->cases[which].motions,
                                        motion);
  if (!better) {
    return false;
  }
  const bool is_new = motion.status != SolveStatus::solved;
  if (!is_new || request_.accuracy == Accuracy::exact) {
    motion = *std::move(better);
  }
  return is_new;
}

bool TypedNumbers::improve(std::size_t which,
                           const std::vector<int>& turned,
                           StaticSolution& action) {
  const bool has_laws = !action.friction.empty() || !action.at_rest.empty() ||
                        action.completion.by != IndeterminateChoice::report;
  if (has_laws || !is_needed(action.status, action.answer, action.evidence) || find() == nullptr) {
    return false;
  }
  std::vector<TypedScrew> actions = typed_->actions;
  for (const int i : turned) {
    const auto flank = static_cast<std::size_t>(i);
    const int turning = mechanism_->geometry.other_flanks[flank].action;
    actions[static_cast<std::size_t>(turning)] = typed_->other_flanks[flank];
  }
  auto better = solve_action_as_typed(
      *mechanism_, actions, mechanism_->cases[which], typed_->cases[which], action);
  if (!better) {
    return false;
  }
  const bool is_new = action.status != better->status;
  if (!is_new || request_.accuracy == Accuracy::exact) {
    better->ignored = std::move(action.ignored);
    if (!is_new) {
      better->self_stresses = std::move(action.self_stresses);
    }
    action = *std::move(better);
  }
  return is_new;
}

}  // namespace kinestat
