#include "run/internal/taped_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "core/tolerance.hpp"
#include "network/bases.hpp"
#include "run/internal/state_solver.hpp"
#include "run/internal/sweep_task.hpp"
#include "run/solve_cases.hpp"

namespace kinestat {

namespace {

bool has_ratios(const Case& which) {
  return !which.inputs.empty() && which.outputs.size() == 1;
}

// The freedoms or the actions of a case that quantities, or the status of a row, need.
std::vector<int> wanted_of(const SweepTask& task, const Case& which, NetworkSide side) {
  std::set<int> wanted;
  for (const SweepQuantity& quantity : task.quantities) {
    const bool is_of_side =
        quantity.kind ==
        (side == NetworkSide::motion ? SweepQuantityKind::rate : SweepQuantityKind::action);
    if (is_of_side) {
      wanted.insert(quantity.index);
    }
  }
  for (const auto* ends : {&which.inputs, &which.outputs}) {
    for (const int i : *ends) {
      const auto& actuator = task.mechanism.topology.actuators[static_cast<std::size_t>(i)];
      wanted.insert(side == NetworkSide::motion ? actuator.freedom : actuator.action);
    }
  }
  return {wanted.begin(), wanted.end()};
}

// Parameters that vary, and those that follow from them.
std::vector<bool> varying_parameters(const SweepPlan& plan) {
  std::vector<bool> varies(plan.slots().values.size(), false);
  for (const SweepAxis& axis : plan.axes()) {
    varies[static_cast<std::size_t>(axis.parameter())] = true;
  }
  for (const DependentParameter& one : plan.dependents()) {
    varies[static_cast<std::size_t>(one.parameter)] = true;
  }
  return varies;
}

// States spread over the whole sweep, whether a requirement excludes them or not.
std::vector<std::uint64_t> sample_states(const SweepPlan& plan) {
  constexpr std::uint64_t kCount = 12;
  constexpr std::uint64_t kStride = 2654435761U;  // visits all axes at unlike places
  std::vector<std::uint64_t> states = {0, plan.state_count() - 1};
  for (std::uint64_t i = 1; i < kCount; ++i) {
    states.push_back(i * kStride % plan.state_count());
  }
  return states;
}

// The parameters of a state.
Slots slots_at(const SweepPlan& plan, std::uint64_t state) {
  Slots slots = plan.slots();
  for (std::size_t i = 0; i < plan.axes().size(); ++i) {
    const SweepAxis& axis = plan.axes()[i];
    const auto slot = static_cast<std::size_t>(axis.parameter());
    slots.values[slot] = axis.value_at(state / plan.stride(static_cast<int>(i)) % axis.size());
    slots.has_value[slot] = true;
  }
  std::vector<Quantity> scratch;
  for (const DependentParameter& one : plan.dependents()) {
    const auto slot = static_cast<std::size_t>(one.parameter);
    const std::optional<Quantity> value = one.value.evaluate(slots, scratch);
    slots.values[slot] = value.value_or(Quantity{});
    slots.has_value[slot] = value.has_value();
  }
  return slots;
}

bool has_same_screws(const Geometry& a, const Geometry& b) {
  const auto is_same = [](const auto& x, const auto& y) {
    return x.coordinates() == y.coordinates();
  };
  return std::ranges::equal(a.motions, b.motions, is_same) &&
         std::ranges::equal(a.actions, b.actions, is_same);
}

// Geometries of some states; empty where what is rebound is not what is bound.
std::optional<std::vector<Geometry>> find_samples(const SweepTask& task, Rebinder& rebinder) {
  std::vector<Geometry> samples;
  StateBinder binder(task);
  for (const std::uint64_t state : sample_states(task.plan)) {
    const Slots slots = slots_at(task.plan, state);
    Geometry geometry = task.mechanism.geometry;
    const std::optional<Mechanism> whole = binder.bind(slots);
    if (!whole || !rebinder.rebind_geometry(slots, geometry)) {
      continue;
    }
    if (!has_same_screws(geometry, whole->geometry)) {
      return std::nullopt;
    }
    samples.push_back(std::move(geometry));
  }
  return samples;
}

bool is_plain(const SweepTask& task, const CaseAnalysis& one) {
  const bool has_motion = !one.motion || one.motion->status == SolveStatus::solved;
  const bool has_action = !one.action || one.action->status == SolveStatus::solved;
  return has_motion && has_action && one.which.loads.empty() &&
         std::ranges::none_of(task.quantities, [](const SweepQuantity& quantity) {
           return needs_power(quantity.kind);
         });
}

// False where a tape is needed and none can be made.
bool record_case(const SweepTask& task,
                 const std::vector<Geometry>& samples,
                 const Rebinder& rebinder,
                 const CaseAnalysis& one,
                 TapedCase& taped) {
  const Mechanism& mechanism = task.mechanism;
  taped.freedoms = wanted_of(task, one.which, NetworkSide::motion);
  taped.actions = wanted_of(task, one.which, NetworkSide::action);
  const auto record = [&](NetworkSide side,
                          const CoordinateBasis& basis,
                          const std::vector<Primary>& primaries,
                          const std::vector<int>& wanted) {
    return NetworkTape::record({.side = side,
                                .mechanism = &mechanism,
                                .basis = &basis,
                                .moves = &rebinder.moves(),
                                .samples = samples,
                                .primaries = primaries,
                                .wanted = wanted});
  };
  if (one.motion) {
    const CoordinateBasis basis = motion_basis(mechanism.geometry, mechanism.kinematic_order);
    taped.motion = record(NetworkSide::motion, basis, one.which.motions, taped.freedoms);
  }
  if (one.action) {
    const CoordinateBasis basis = action_basis(mechanism.geometry, mechanism.static_order);
    taped.action = record(NetworkSide::action, basis, one.which.actions, taped.actions);
  }
  return taped.motion.has_value() == one.motion.has_value() &&
         taped.action.has_value() == one.action.has_value();
}

// A tape keeps no torque of a freewheel. The class of a combination hangs on the speeds where there
// are several inputs, and those of the state are not at hand.
bool knows_gears(const SweepTask& task) {
  if (!task.shift) {
    return true;
  }
  const bool has_freewheels = std::ranges::any_of(
      task.shift->elements, [](const ShiftElement& element) { return element.one_way != 0; });
  const bool has_combinations =
      std::ranges::any_of(task.gears, [](const std::optional<SweptGear>& gear) {
        return gear && gear->state.state.kind != ShiftClass::gear;
      });
  return !has_freewheels && (task.shift->inputs.size() == 1 || !has_combinations);
}

}  // namespace

std::optional<SweepTapes> record_tapes(const SweepTask& task) {
  // What a case that the file does not write itself knows is not looked into.
  const std::size_t written = task.description.cases.size();
  if (std::ranges::any_of(task.chosen, [&](std::size_t i) { return i >= written; })) {
    return std::nullopt;
  }
  if (!knows_gears(task)) {
    return std::nullopt;
  }
  std::optional<Rebinder> rebinder =
      Rebinder::make(task.description, task.mechanism, varying_parameters(task.plan));
  if (!rebinder) {
    return std::nullopt;
  }
  const auto samples = find_samples(task, *rebinder);
  if (!samples) {
    return std::nullopt;
  }
  SweepTapes tapes{.rebinder = *std::move(rebinder), .cases = {}};
  const std::vector<CaseAnalysis> cases = solve_some_cases(task.mechanism, task.cases);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    tapes.cases.emplace_back();
    const bool is_taped = !task.gears[i] || task.gears[i]->state.state.kind == ShiftClass::gear;
    if (is_taped && (!is_plain(task, cases[i]) ||
                     !record_case(task, *samples, tapes.rebinder, cases[i], tapes.cases.back()))) {
      return std::nullopt;
    }
  }
  return tapes;
}

TapedSolver::TapedSolver(const SweepTask& task, const SweepTapes& tapes)
    : task_(task),
      tapes_(tapes),
      rebinder_(tapes.rebinder),
      mechanism_(task.mechanism),
      all_cases_(task.mechanism.cases) {
  for (std::size_t i = 0; i < task.cases.size(); ++i) {
    const TapedCase& taped = tapes.cases[i];
    has_combinations_ = has_combinations_ || is_no_gear(i);
    CaseAnalysis one;
    one.which = task.cases[i];
    Work work;
    if (taped.motion) {
      one.motion.emplace();
      one.motion->rates.assign(task.mechanism.topology.freedoms.size(), 0.0);
      work.motion = taped.motion->make_workspace();
    }
    if (taped.action) {
      one.action.emplace();
      one.action->magnitudes.assign(task.mechanism.topology.actions.size(), std::nullopt);
      work.action = taped.action->make_workspace();
    }
    if (taped.motion && has_ratios(one.which)) {
      one.ratios.emplace();
    }
    analyses_.push_back(std::move(one));
    work_.push_back(std::move(work));
  }
}

bool TapedSolver::solve(const StateWalk& walk, std::span<SweepRow> rows) {
  if (!rebinder_.rebind_geometry(walk.slots(), mechanism_.geometry) ||
      !rebinder_.rebind_cases(walk.slots(), all_cases_)) {
    return false;
  }
  if (has_combinations_ && !decide_gears(rows)) {
    return false;
  }
  for (std::size_t i = 0; i < analyses_.size(); ++i) {
    if (!is_no_gear(i) && (!solve_case(i) || (task_.gears[i] && !drives_output(i)))) {
      return false;
    }
  }
  std::vector<std::optional<double>> ratios(rows.size());
  for (std::size_t i = 0; i < analyses_.size(); ++i) {
    if (!is_no_gear(i)) {
      fill_row(task_, task_.mechanism, analyses_[i], rows[i]);
      rows[i].status = row_status(analyses_[i], task_, true);
      ratios[i] = gear_ratio(task_, i, analyses_[i]);
    }
  }
  fill_steps(task_.quantities, ratios, rows);
  return true;
}

bool TapedSolver::is_no_gear(std::size_t i) const {
  return task_.gears[i] && task_.gears[i]->state.state.kind != ShiftClass::gear;
}

// Of the combinations without a tape; false where one of them is a gear here.
bool TapedSolver::decide_gears(std::span<SweepRow> rows) {
  const auto states = find_states(task_.gears, mechanism_, *task_.shift);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!is_no_gear(i)) {
      continue;
    }
    if (states[i]->kind == ShiftClass::gear) {
      return false;
    }
    rows[i].status = word_of(states[i]->kind);
    std::ranges::fill(rows[i].values, std::numeric_limits<double>::quiet_NaN());
  }
  return true;
}

// A gear whose outputs rest is none: then the whole analysis decides.
bool TapedSolver::drives_output(std::size_t i) const {
  const CaseAnalysis& one = analyses_[i];
  const auto rate_of = [&](int actuator) {
    const auto& label = task_.mechanism.topology.actuators[static_cast<std::size_t>(actuator)];
    return std::abs(one.motion->rates[static_cast<std::size_t>(label.freedom)]);
  };
  double largest = 0.0;
  for (const int input : one.which.inputs) {
    largest = std::max(largest, rate_of(input));
  }
  return std::ranges::any_of(one.which.outputs,
                             [&](int output) { return rate_of(output) > kSameValue * largest; });
}

bool TapedSolver::solve_case(std::size_t i) {
  CaseAnalysis& one = analyses_[i];
  if ((one.motion && !solve_motion(i)) || (one.action && !solve_action(i))) {
    return false;
  }
  if (one.ratios) {
    *one.ratios =
        find_ratios(task_.mechanism, one.which, *one.motion, one.action ? &*one.action : nullptr);
  }
  return true;
}

bool TapedSolver::solve_motion(std::size_t i) {
  const TapedCase& taped = tapes_.cases[i];
  const Case& which = all_cases_[task_.chosen[i]];
  EliminationTape::Workspace& workspace = work_[i].motion;
  if (!taped.motion->eliminate(mechanism_.geometry, workspace) ||
      !taped.motion->solve(which.motions, workspace, known_, wanted_)) {
    return false;
  }
  for (std::size_t k = 0; k < wanted_.size(); ++k) {
    analyses_[i].motion->rates[static_cast<std::size_t>(taped.freedoms[k])] = wanted_[k];
  }
  return true;
}

bool TapedSolver::solve_action(std::size_t i) {
  const TapedCase& taped = tapes_.cases[i];
  const Case& which = all_cases_[task_.chosen[i]];
  EliminationTape::Workspace& workspace = work_[i].action;
  if (!taped.action->eliminate(mechanism_.geometry, workspace) ||
      !taped.action->solve(which.actions, workspace, known_, wanted_)) {
    return false;
  }
  for (std::size_t k = 0; k < wanted_.size(); ++k) {
    analyses_[i].action->magnitudes[static_cast<std::size_t>(taped.actions[k])] = wanted_[k];
  }
  return true;
}

}  // namespace kinestat
