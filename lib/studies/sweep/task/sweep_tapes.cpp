#include "studies/sweep/task/sweep_tapes.hpp"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "cases/solve_cases.hpp"
#include "studies/sweep/state_rules.hpp"
#include "studies/sweep/task/internal/gear_axes_tape.hpp"
#include "studies/sweep/task/sweep_samples.hpp"
#include "studies/sweep/task/sweep_screws.hpp"
#include "studies/sweep/task/sweep_task.hpp"

namespace kinestat {

namespace {

bool is_plain(const SweepTask& task, const CaseAnalysis& one) {
  const bool has_motion = !one.motion || one.motion->status == SolveStatus::solved;
  const bool has_action = !one.action || one.action->status == SolveStatus::solved;
  const bool has_laws = std::ranges::any_of(
      task.mechanism.lossy_meshes, [](const LossyMesh& mesh) { return mesh.law.has_value(); });
  const bool is_linear = !one.action || (task.mechanism.frictions.empty() && !has_laws);
  const bool has_idle = one.motion && !one.motion->idle.empty();  // whose rates have no value
  return has_motion && has_action && is_linear && !has_idle && !one.which.has_inertia() &&
         !one.which.follows_curves() && one.which.loads.empty() &&
         task.mechanism.contacts.empty() &&
         (task.mechanism.freewheels.empty() || one.which.is_gear);
}

// A tape keeps no torque of a freewheel, and the class of a combination hangs on the speeds where
// there are several inputs: those that follow from others may contradict them in another state.
bool knows_gears(const SweepTask& task) {
  if (!task.shift || std::ranges::none_of(task.gears, &std::optional<SweptGear>::has_value)) {
    return true;
  }
  const bool has_freewheels = std::ranges::any_of(
      task.shift->elements, [](const ShiftElement& element) { return element.one_way != 0; });
  return !has_freewheels && task.shift->inputs.size() == 1;
}

bool has_input(const SweepNotes& notes, std::initializer_list<SweepInput::From> from) {
  return std::ranges::any_of(notes.inputs, [&](const SweepInput& input) {
    return std::ranges::find(from, input.from) != from.end();
  });
}

// Whether a coordinate of a screw moves where couplings are rebound.
bool moves_with(const Rebinder& rebinder, const Mechanism& mechanism, const SweepInput& input) {
  const Topology& topology = mechanism.topology;
  const auto action_of = [&](std::size_t flank) {
    return static_cast<std::size_t>(mechanism.geometry.other_flanks[flank].action);
  };
  const CouplingId coupling =
      input.from == SweepInput::From::motion  ? topology.freedoms[input.index].coupling
      : input.from == SweepInput::From::flank ? topology.actions[action_of(input.index)].coupling
                                              : topology.actions[input.index].coupling;
  const auto e = static_cast<std::size_t>(coupling.value);
  const bool is_direction = (input.from == SweepInput::From::motion) == (input.part < 3);
  return rebinder.moves()[e] && (rebinder.turns()[e] || !is_direction);
}

// Parameters and the screws that follow from them: by formulas where that can be, otherwise from
// what is rebound for each state.
std::pair<SweepNotes, TapedScrews> note_geometry(const SweepTask& task,
                                                 const Rebinder& rebinder,
                                                 std::span<const SweepSample> samples) {
  for (const NearOrigin near : {NearOrigin::by_fixed_points, NearOrigin::by_all_points}) {
    SweepNotes notes = note_parameters(task.plan);
    if (auto screws = note_screws(rebinder, near, task.mechanism.geometry, samples, notes)) {
      return {std::move(notes), *std::move(screws)};
    }
  }
  const auto moves = [&](const SweepInput& input) {
    return moves_with(rebinder, task.mechanism, input);
  };
  SweepNotes notes = note_parameters(task.plan);
  TapedScrews screws = take_screws(task.mechanism, moves, notes);
  return {std::move(notes), std::move(screws)};
}

std::vector<TapeNumber> note_shares(const SweepTask& task,
                                    const std::optional<BoundNumbers>& bound,
                                    SweepNotes& notes) {
  std::vector<TapeNumber> shares;
  for (std::size_t m = 0; m < task.mechanism.lossy_meshes.size(); ++m) {
    const SweepInput input{.from = SweepInput::From::share, .index = m, .part = 0, .dimension = {}};
    const double share = task.mechanism.lossy_meshes[m].share;
    shares.push_back(bound && bound->moves(input) ? notes.take(input, share)
                                                  : notes.recorder.constant(share));
  }
  return shares;
}

std::vector<Geometry> geometries_of(std::span<const SweepSample> samples) {
  std::vector<Geometry> geometries;
  for (const SweepSample& sample : samples) {
    geometries.push_back(sample.mechanism.geometry);
  }
  return geometries;
}

// What follows from the parameters is in the mechanism of each state.
std::pair<SweepNotes, TapedScrews> note_bound(const SweepTask& task, const BoundNumbers& bound) {
  SweepNotes notes;
  notes.slots.resize(task.plan.slots().values.size());
  TapedScrews screws = take_screws(
      task.mechanism, [&](const SweepInput& input) { return bound.moves(input); }, notes);
  return {std::move(notes), std::move(screws)};
}

BoundNumbers bound_numbers(const SweepTask& task, std::span<const SweepSample> samples) {
  std::vector<Mechanism> mechanisms;
  for (const SweepSample& sample : samples) {
    mechanisms.push_back(sample.mechanism);
  }
  return BoundNumbers(task.mechanism, mechanisms);
}

// Combinations that are no gears with the parameters of the file have none.
bool has_tape(const SweepTask& task, std::size_t i) {
  return !task.gears[i] || task.gears[i]->state.state.kind == ShiftClass::gear;
}

bool are_plain(const SweepTask& task, std::span<const CaseAnalysis> solved) {
  for (std::size_t i = 0; i < solved.size(); ++i) {
    if (has_tape(task, i) && !is_plain(task, solved[i])) {
      return false;
    }
  }
  return true;
}

// Empty where one of the cases has no tape.
std::optional<std::vector<CaseTape>> note_cases(const SweepTask& task,
                                                std::span<const CaseAnalysis> solved,
                                                const SweptNumbers& numbers,
                                                SweepNotes& notes) {
  std::vector<CaseTape> cases(solved.size());
  for (std::size_t i = 0; i < solved.size(); ++i) {
    if (!has_tape(task, i)) {
      continue;
    }
    auto taped = note_case(task, i, solved[i], numbers, notes);
    if (!taped) {
      return std::nullopt;
    }
    cases[i] = *std::move(taped);
  }
  return cases;
}

}  // namespace

std::optional<SweepTapes> record_tapes(const SweepTask& task) {
  // What a case that the file does not write itself knows is not looked into.
  // Nor is how places of masses move, and a report is of a case that is solved as a whole.
  if (task.motion || asks(task.columns, SweepColumnKind::equivalent_inertia) ||
      asks(task.columns, SweepColumnKind::reported)) {
    return std::nullopt;
  }
  const std::size_t written = task.description.cases.size();
  if (std::ranges::any_of(task.chosen, [&](std::size_t i) { return i >= written; }) ||
      !knows_gears(task)) {
    return std::nullopt;
  }
  const std::vector<CaseAnalysis> solved = solve_some_cases(task.mechanism, task.cases);
  if (!are_plain(task, solved)) {
    return std::nullopt;
  }
  std::optional<Rebinder> rebinder =
      Rebinder::make(task.description, task.mechanism, varying_parameters(task.plan));
  const std::vector<SweepSample> samples = find_samples(task);
  if (std::ranges::any_of(samples, [&](const SweepSample& one) {
        return !has_same_parts(one.mechanism, task.mechanism);
      })) {
    return std::nullopt;
  }
  std::optional<BoundNumbers> bound;
  if (!rebinder || !rebinds(*rebinder, task, samples)) {
    rebinder.reset();
    bound = bound_numbers(task, samples);
  }
  auto [notes, screws] =
      rebinder ? note_geometry(task, *rebinder, samples) : note_bound(task, *bound);
  const std::vector<TapeNumber> shares = note_shares(task, bound, notes);
  const std::vector<Geometry> geometries = geometries_of(samples);
  auto cases =
      note_cases(task,
                 solved,
                 {.rebinder = rebinder ? &*rebinder : nullptr,
                  .bound = bound ? &*bound : nullptr,
                  .screws = &screws,
                  .samples = geometries,
                  .shares = shares,
                  .keeps_axes = !asks_power(task.columns) ||
                                demand_same_axes(task.mechanism, screws.motions, notes.recorder)},
                 notes);
  if (!cases) {
    return std::nullopt;
  }
  using enum SweepInput::From;
  SweepTapes tapes{.rebinder = std::move(rebinder),
                   .bound = std::move(bound),
                   .rules = std::make_shared<StateRules>(task.plan, task.description),
                   .tape = notes.recorder.make_tape(notes.outputs),
                   .inputs = notes.inputs,
                   .needs_geometry = has_input(notes, {motion, action, flank}),
                   .needs_primaries = has_input(notes, {primary_motion, primary_action}),
                   .cases = *std::move(cases)};
  for (CaseTape& taped : tapes.cases) {
    find_cells(tapes.tape, taped);
  }
  return tapes;
}

}  // namespace kinestat
