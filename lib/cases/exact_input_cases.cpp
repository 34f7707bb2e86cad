#include "cases/exact_input_cases.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "kinematics/exact_input_velocity.hpp"
#include "statics/exact_input_action.hpp"

namespace kinestat {

namespace {

constexpr int kMostMagnitudes = 500;

// Of a place as share of the size of the mechanism, from whose origin it may be some sizes away.
constexpr double kPlaceRounding = kFarOrigin * kEpsilon;

// By how much the largest of the values exceeds the smallest that is not zero.
double spread_of(std::span<const double> values) {
  double largest = 0.0;
  double smallest = std::numeric_limits<double>::infinity();
  for (const double value : values) {
    const double size = std::abs(value);
    largest = std::max(largest, size);
    smallest = size > 0.0 ? std::min(smallest, size) : smallest;
  }
  return largest > 0.0 ? largest / smallest : 1.0;
}

// In units that hold the size of the mechanism instead of lengths.
std::vector<double> comparable_rates(const Mechanism& mechanism, const KinematicSolution& motion) {
  std::vector<double> values = motion.rates;
  for (std::size_t f = 0; f < values.size(); ++f) {
    values[f] /= mechanism.topology.freedoms[f].is_rotation ? 1.0 : mechanism.geometry.length;
  }
  return values;
}

std::vector<double> comparable_actions(const Mechanism& mechanism, const StaticSolution& action) {
  std::vector<double> values;
  for (std::size_t a = 0; a < action.magnitudes.size(); ++a) {
    const double unit = mechanism.topology.actions[a].is_couple ? mechanism.geometry.length : 1.0;
    values.push_back(action.magnitudes[a].value_or(0.0) / unit);
  }
  return values;
}

}  // namespace

void check_exact_input(const MechanismDescription& description,
                       const Mechanism& mechanism,
                       const AccuracyRequest& request,
                       Diagnostics& found) {
  if (request.accuracy == Accuracy::exact) {
    (void)bind_exact_input(description, mechanism, found);
  }
}

const ExactInputMechanism* ExactInputCases::find() {
  if (!is_bound_) {
    Diagnostics ignored;  // the doubles answer then
    exact_input_ = bind_exact_input(*description_, *mechanism_, ignored);
    is_bound_ = true;
  }
  return exact_input_ ? &*exact_input_ : nullptr;
}

bool ExactInputCases::is_small() const {
  const Topology& topology = mechanism_->topology;
  return topology.freedom_count() + topology.action_count() <= kMostMagnitudes;
}

// The answer of one side of a case in doubles.
struct ExactInputCases::DoubleAnswer {
  SolveStatus status;
  const AnswerEvidence& answer;
  const RankEvidence& evidence;
  std::vector<double> values;
  const RankEvidence* beside = nullptr;  ///< of the other side; null where that has no answer
};

// A pivot this small, or magnitudes that are small differences of larger ones, may have lost the
// digits asked for when the numbers were rounded to double. Powers balance, so that what cancels in
// the motion cancels in the actions too, but it shows in the pivots of only one of them.
bool ExactInputCases::is_needed(const DoubleAnswer& of) const {
  const bool can_improve =
      of.status == SolveStatus::solved || of.status == SolveStatus::dependent ||
      of.status == SolveStatus::underdetermined || of.status == SolveStatus::inconsistent;
  if (!can_improve) {
    return false;
  }
  const double own = of.evidence.smallest_pivot;
  const bool has_other = of.beside != nullptr && of.beside->rank > 0;
  const double pivot = has_other ? std::min(own, of.beside->smallest_pivot) : own;
  const double lost = kCancellation / own;
  const double rounded = kPlaceRounding / pivot;
  const double asked = std::pow(10.0, -request_.digits);
  const bool is_sure = of.status == SolveStatus::solved && reaches(of.answer, request_.digits) &&
                       lost <= asked && rounded * spread_of(of.values) <= asked;
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

bool ExactInputCases::asks_for_exact_input(const RankCertainty& certainty) {
  const bool is_wanted = request_.accuracy == Accuracy::exact;
  return (is_wanted || (certainty.how != "structural" && is_small())) && find() != nullptr;
}

void ExactInputCases::find_ranks(bool with_actions, Certainty& certainty) {
  certainty.motion_rank = find_motion_certainty(*mechanism_);
  if (asks_for_exact_input(*certainty.motion_rank)) {
    add_exact_input_motions(*mechanism_, *exact_input_, *certainty.motion_rank);
  }
  if (!with_actions) {
    return;
  }
  certainty.action_rank = find_action_certainty(*mechanism_);
  if (asks_for_exact_input(*certainty.action_rank)) {
    add_exact_input_actions(*mechanism_, *exact_input_, *certainty.action_rank);
  }
}

void ExactInputCases::count_exact_input(const Certainty& certainty, MobilityCounts& counts) const {
  const int more_motions = missing_rank(certainty.motion_rank, counts.minimal.motions.rank);
  const int more_actions = counts.minimal.actions
                               ? missing_rank(certainty.action_rank, counts.minimal.actions->rank)
                               : 0;
  const auto add = [&](SideCounts& side) {
    side.motions.rank += more_motions;
    side.motions.net_freedom -= more_motions;
    side.motions.net_constraint -= more_motions;
    if (side.actions) {
      side.actions->rank += more_actions;
      side.actions->net_constraint -= more_actions;
      side.actions->net_freedom -= more_actions;
    }
  };
  add(counts.minimal);
  add(counts.spatial);
  if (counts.planar) {
    add(*counts.planar);
  }
}

// By how much the rank as typed exceeds the one that was counted.
int ExactInputCases::missing_rank(const std::optional<RankCertainty>& certainty,
                                  int counted) const {
  if (!certainty || !certainty->exact_input) {
    return 0;
  }
  const int missing = certainty->exact_input->rank - counted;
  return request_.accuracy == Accuracy::exact ? missing : std::min(missing, 0);
}

std::optional<KinematicSolution> ExactInputCases::find_better(std::size_t which,
                                                              std::span<const Primary> known,
                                                              const RankEvidence* beside,
                                                              const KinematicSolution& motion) {
  if (!is_needed({.status = motion.status,
                  .answer = motion.answer,
                  .evidence = motion.evidence,
                  .values = comparable_rates(*mechanism_, motion),
                  .beside = beside}) ||
      find() == nullptr) {
    return std::nullopt;
  }
  std::vector<ExactInput> values = exact_input_->cases[which].motions;
  for (std::size_t i = values.size(); i < known.size(); ++i) {
    KINESTAT_EXPECTS(known[i].is_assumed);
    values.emplace_back(known[i].value);
  }
  auto better =
      solve_velocity_of_exact_input(*mechanism_, exact_input_->motions, known, values, motion);
  if (better) {
    better->idle = motion.idle;
  }
  return better;
}

bool ExactInputCases::improve(std::size_t which,
                              std::span<const Primary> known,
                              KinematicSolution& motion) {
  auto better = find_better(which, known, nullptr, motion);
  if (!better) {
    return false;
  }
  const bool is_new = motion.status != SolveStatus::solved;
  if (!is_new || request_.accuracy == Accuracy::exact) {
    motion = *std::move(better);
  }
  return is_new;
}

void ExactInputCases::improve_beside(std::size_t which,
                                     std::span<const Primary> known,
                                     const StaticSolution& action,
                                     KinematicSolution& motion) {
  if (action.status != SolveStatus::solved || motion.answer.is_exact_input) {
    return;
  }
  if (auto better = find_better(which, known, &action.evidence, motion)) {
    motion = *std::move(better);
  }
}

bool ExactInputCases::improve(std::size_t which,
                              const Mechanism& loaded,
                              const std::vector<int>& turned,
                              const KinematicSolution* motion,
                              StaticSolution& action) {
  const bool has_laws = !action.friction.empty() || !action.at_rest.empty() ||
                        action.completion.by != IndeterminateChoice::report;
  if (has_laws ||
      !is_needed({.status = action.status,
                  .answer = action.answer,
                  .evidence = action.evidence,
                  .values = comparable_actions(loaded, action),
                  .beside = motion != nullptr ? &motion->evidence : nullptr}) ||
      find() == nullptr) {
    return false;
  }
  std::vector<ExactInputScrew> actions = exact_input_->actions;
  for (const int i : turned) {
    const auto flank = static_cast<std::size_t>(i);
    const int turning = mechanism_->geometry.other_flanks[flank].action;
    actions[static_cast<std::size_t>(turning)] = exact_input_->other_flanks[flank];
  }
  auto better = solve_action_of_exact_input(
      loaded, actions, mechanism_->cases[which], exact_input_->cases[which], action);
  if (!better) {
    return false;
  }
  const bool is_new = action.status != better->status;
  const bool has_answer = better->status != SolveStatus::inconsistent;
  if (!is_new || request_.accuracy == Accuracy::exact) {
    better->ignored = std::move(action.ignored);
    better->held_cables = std::move(action.held_cables);
    if (!is_new) {
      better->self_stresses = std::move(action.self_stresses);
    }
    action = *std::move(better);
  }
  return is_new && has_answer;
}

}  // namespace kinestat
