#include "studies/sweep/task/tape_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/case_status.hpp"
#include "core/tolerance.hpp"
#include "power/rate_ratio.hpp"
#include "studies/sweep/state_rules.hpp"
#include "studies/sweep/task/lane_rows.hpp"
#include "studies/sweep/task/row_status.hpp"
#include "studies/sweep/task/state_solver.hpp"
#include "studies/sweep/task/sweep_task.hpp"

namespace kinestat {

namespace {

double finite(double value) {
  return std::isfinite(value) ? value : kNoValue;
}

bool is_no_gear(const std::optional<SweptGear>& gear) {
  return gear && gear->state.state.kind != ShiftClass::gear;
}

std::vector<std::size_t> find_columns(const std::vector<SweepColumn>& all, SweepColumnKind kind) {
  std::vector<std::size_t> columns;
  for (std::size_t q = 0; q < all.size(); ++q) {
    if (all[q].kind == kind) {
      columns.push_back(q);
    }
  }
  return columns;
}

}  // namespace

TapeSolver::TapeSolver(const SweepTask& task, const SweepTapes& tapes, std::size_t lanes)
    : task_(task),
      tapes_(tapes),
      workspace_(tapes.tape.make_workspace(lanes)),
      rebinder_(tapes.rebinder),
      binder_(tapes.rebinder ? nullptr : std::make_unique<StateBinder>(task)),
      mechanism_(task.mechanism),
      is_loaded_(lanes, 0),
      has_answer_(lanes, 0),
      has_plain_ratios_(lanes * task.cases.size(), 0),
      has_combinations_(std::ranges::any_of(task.gears, is_no_gear)),
      ratio_columns_(find_columns(task.columns, SweepColumnKind::ratio)),
      torque_ratio_columns_(find_columns(task.columns, SweepColumnKind::torque_ratio)),
      efficiency_columns_(find_columns(task.columns, SweepColumnKind::efficiency)),
      recirculation_columns_(find_columns(task.columns, SweepColumnKind::recirculation)),
      asks_steps_(!find_columns(task.columns, SweepColumnKind::step).empty()),
      statuses_(has_combinations_ ? lanes * task.cases.size() : 0),
      ratios_(task.cases.size()) {
  std::size_t most = 0;
  for (const Case& which : task.cases) {
    most = std::max({most, which.inputs.size(), which.outputs.size()});
  }
  rates_.reserve(most);
  powers_.reserve(task.mechanism.topology.actuators.size());
  for (std::size_t i = 0; i < tapes.inputs.size(); ++i) {
    if (!tapes.tape.reads_input(i)) {
      continue;
    }
    const SweepInput& input = tapes.inputs[i];
    const std::size_t cell = tapes.tape.input_cell(i);
    if (input.from == SweepInput::From::axis) {
      axes_.push_back({.axis = input.part, .cell = cell});
    } else {
      others_.push_back({.input = i, .cell = cell});
    }
  }
  binds_states_ = binder_ || tapes.needs_geometry || tapes.needs_primaries || has_combinations_ ||
                  !others_.empty() || !tapes_.rules->are_empty();
  asks_nothing_else_ = std::ranges::none_of(task.gears, &std::optional<SweptGear>::has_value) &&
                       std::ranges::all_of(tapes.cases, [&](const CaseTape& taped) {
                         return taped.columns.size() == task.columns.size() &&
                                taped.one_sided.empty() && !taped.power;
                       });
}

TapeSolver::~TapeSolver() = default;

bool TapeSolver::rebind(const StateWalk& walk) {
  if (binder_) {
    return bind_whole(walk.state());
  }
  const bool needs_geometry = tapes_.needs_geometry || has_combinations_;
  return (!needs_geometry || rebinder_->rebind_geometry(walk.slots(), mechanism_.geometry)) &&
         (!tapes_.needs_primaries || rebinder_->rebind_cases(walk.slots(), mechanism_.cases));
}

bool TapeSolver::bind_whole(std::uint64_t state) {
  std::optional<Mechanism> mechanism = binder_->bind(state);
  if (!mechanism || !tapes_.bound->are_kept_by(*mechanism)) {
    return false;
  }
  mechanism_ = *std::move(mechanism);
  return true;
}

// Alike states differ on the last axis.
void TapeSolver::load_axes(const StateWalk& walk, std::size_t lane, std::size_t count) {
  const std::span<const SweepAxis> axes = task_.plan.axes();
  for (const AxisLoad& one : axes_) {
    const std::uint64_t place = walk.places()[one.axis];
    const double first = axes[one.axis].number_at(place);
    const bool is_last = one.axis + 1 == axes.size();
    for (std::size_t i = 0; i < count; ++i) {
      workspace_.set(one.cell, lane + i, is_last ? axes[one.axis].number_at(place + i) : first);
    }
  }
}

void TapeSolver::load(const StateWalk& walk, std::size_t lane, std::size_t count) {
  load_axes(walk, lane, count);
  const bool is_loaded = !binds_states_ || bind(walk, lane);
  std::fill_n(is_loaded_.begin() + static_cast<std::ptrdiff_t>(lane), count, is_loaded ? 1 : 0);
}

// What follows from the place on the axes; false where the state must be analysed as a whole.
bool TapeSolver::bind(const StateWalk& walk, std::size_t lane) {
  return tapes_.rules->hold(walk.slots(), scratch_) && rebind(walk) &&
         (!has_combinations_ || decide_gears(lane)) &&
         std::ranges::all_of(others_, [&](const Load& one) {
           return load_other(tapes_.inputs[one.input], one.cell, walk, lane);
         });
}

bool TapeSolver::load_other(const SweepInput& input,
                            std::size_t cell,
                            const StateWalk& walk,
                            std::size_t lane) {
  const bool is_parameter =
      input.from == SweepInput::From::axis || input.from == SweepInput::From::parameter;
  if (is_parameter) {
    const Quantity& quantity = walk.slots().values[input.index];
    if (!walk.slots().has_value[input.index] || quantity.dimension != input.dimension) {
      return false;
    }
  }
  const double value =
      is_parameter ? walk.slots().values[input.index].value : number_of(input, mechanism_);
  workspace_.set(cell, lane, value);
  return true;
}

// Of the combinations without a tape; false where one of them is a gear here.
bool TapeSolver::decide_gears(std::size_t lane) {
  const auto states = find_states(task_.gears, mechanism_, *task_.shift);
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (is_no_gear(task_.gears[i])) {
      if (states[i]->kind == ShiftClass::gear) {
        return false;
      }
      statuses_[lane * states.size() + i] = word_of(states[i]->kind);
    }
  }
  return true;
}

void TapeSolver::fill(std::size_t count, std::span<SweepRow> rows) {
  const std::size_t cases = task_.cases.size();
  for (std::size_t lane = 0; lane < count; ++lane) {
    has_answer_[lane] = is_loaded_[lane] != 0 && tapes_.tape.is_met(workspace_, lane) ? 1 : 0;
  }
  for (std::size_t i = 0; i < cases; ++i) {
    if (!is_no_gear(task_.gears[i])) {
      fill_columns(i, rows);
    }
  }
  for (std::size_t lane = 0; lane < count && !asks_nothing_else_; ++lane) {
    const bool is_filled =
        has_answer_[lane] != 0 && fill_cases(lane, rows.subspan(lane * cases, cases));
    has_answer_[lane] = is_filled ? 1 : 0;
  }
}

// What the tape alone decides on, of all lanes: where no state is in one, too.
void TapeSolver::fill_columns(std::size_t i, std::span<SweepRow> rows) {
  const std::size_t cases = task_.cases.size();
  const CaseTape& taped = tapes_.cases[i];
  const std::span<SweepRow> from = rows.subspan(i);
  for (std::size_t lane = 0; lane < workspace_.lanes(); ++lane) {
    SweepRow& row = from[lane * cases];
    row.status = "solved";
    if (taped.columns.size() + taped.ratios.size() < row.values.size()) {
      std::ranges::fill(row.values, kNoValue);
    }
  }
  LaneMagnitudes columns(taped.known);
  columns.add(workspace_, taped.columns);
  fill_lanes(workspace_, taped.columns, from, cases);
  keep_clear(columns);
  if (!taped.input_rates.empty() || !taped.output_rates.empty()) {
    demand_clear_ends(taped.input_rates, taped.output_rates);
  }
  if (!taped.input_actions.empty() || !taped.output_actions.empty()) {
    demand_clear_ends(taped.input_actions, taped.output_actions);
  }
  if (!taped.ratios.empty() && !task_.gears[i]) {
    LaneMagnitudes ratios(1.0);
    ratios.add(workspace_, taped.ratios);
    fill_lanes(workspace_, taped.ratios, from, cases);
    for (std::size_t lane = 0; lane < workspace_.lanes(); ++lane) {
      has_plain_ratios_[lane * cases + i] = ratios.are_clear(lane) ? 1 : 0;
    }
  }
}

void TapeSolver::keep_clear(const LaneMagnitudes& magnitudes) {
  std::size_t lane = 0;
  for (char& has_answer : has_answer_) {
    const bool is_clear = magnitudes.are_clear(lane++);
    has_answer = has_answer != 0 && is_clear ? 1 : 0;
  }
}

// An input or output may be so small beside the other that it is rounding, and a ratio of them
// nothing: then the whole analysis decides.
void TapeSolver::demand_clear_ends(std::span<const std::size_t> inputs,
                                   std::span<const std::size_t> outputs) {
  LaneMagnitudes ends;
  ends.add(workspace_, inputs);
  ends.add(workspace_, outputs);
  keep_clear(ends);
}

bool TapeSolver::fill_cases(std::size_t lane, std::span<SweepRow> rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ratios_[i].reset();
    if (is_no_gear(task_.gears[i])) {
      rows[i].status = statuses_[lane * rows.size() + i];
      std::ranges::fill(rows[i].values, kNoValue);
    } else if (!fill_case(i, lane, rows[i])) {
      return false;
    }
  }
  if (asks_steps_) {
    fill_steps(task_.columns, task_.forward, ratios_, rows);
  }
  return true;
}

std::span<const double> TapeSolver::read(std::span<const std::size_t> outputs, std::size_t lane) {
  rates_.clear();
  for (const std::size_t output : outputs) {
    rates_.push_back(workspace_.number(output, lane));
  }
  return rates_;
}

// A gear whose outputs rest is none: then the whole analysis decides.
bool TapeSolver::drives_output(const CaseTape& taped, std::size_t lane) {
  double largest = 0.0;
  for (const double rate : read(taped.input_rates, lane)) {
    largest = std::max(largest, std::abs(rate));
  }
  return std::ranges::any_of(read(taped.output_rates, lane),
                             [&](double rate) { return std::abs(rate) > kSameValue * largest; });
}

// Whether actions of several inputs leave a sum; where they cancel, the whole analysis decides
// whether it is zero.
bool TapeSolver::sums_inputs(const CaseTape& taped, std::size_t lane) {
  if (taped.input_actions.size() < 2) {
    return true;
  }
  double sum = 0.0;
  double terms = 0.0;
  for (const double action : read(taped.input_actions, lane)) {
    sum += action;
    terms += std::abs(action);
  }
  return std::abs(sum) > kSameValue * terms;
}

TapeSolver::TapedRatios TapeSolver::find_ratios(const CaseTape& taped, std::size_t lane) {
  const std::optional<double> fast = common_rate(read(taped.input_rates, lane));
  if (!fast) {
    return {};
  }
  TapedRatios ratios{.ratio = share_of(fast, workspace_.number(taped.output_rates.front(), lane)),
                     .torque_ratio = {}};
  if (!taped.output_actions.empty()) {
    double sum = 0.0;
    for (const double action : read(taped.input_actions, lane)) {
      sum += action;
    }
    ratios.torque_ratio = share_of(sum, workspace_.number(taped.output_actions.front(), lane));
  }
  return ratios;
}

std::string_view TapeSolver::status_of(const CaseTape& taped,
                                       const TapedRatios& ratios,
                                       std::size_t lane) {
  if (ratio_columns_.empty() || !taped.has_ratios || ratios.ratio) {
    return "solved";
  }
  const bool rests =
      std::ranges::all_of(read(taped.input_rates, lane), [](double rate) { return rate == 0.0; });
  return status_without_ratio(rests);
}

void TapeSolver::fill_ratios(const CaseTape& taped,
                             const TapedRatios& ratios,
                             SweepRow& row) const {
  const double ratio = ratios.ratio.value_or(kNoValue);
  for (const std::size_t column : ratio_columns_) {
    row.values[column] = finite(ratio * taped.ratio_unit / taped.ratio_per);
  }
  const double torque_ratio = ratios.torque_ratio.value_or(kNoValue);
  for (const std::size_t column : torque_ratio_columns_) {
    row.values[column] = finite(torque_ratio * taped.torque_ratio_unit / taped.torque_ratio_per);
  }
}

// Whether no cable pushes and no contact pulls.
bool TapeSolver::is_possible(const CaseTape& taped, std::size_t lane) const {
  return std::ranges::all_of(
      taped.one_sided, [&](std::size_t cell) { return workspace_.number(cell, lane) >= 0.0; });
}

// False where the case is no gear or not possible in this state.
bool TapeSolver::fill_case(std::size_t i, std::size_t lane, SweepRow& row) {
  const CaseTape& taped = tapes_.cases[i];
  if ((task_.gears[i] && !drives_output(taped, lane)) || !is_possible(taped, lane) ||
      !sums_inputs(taped, lane)) {
    return false;
  }
  if (taped.has_ratios && has_plain_ratios_[lane * task_.cases.size() + i] == 0) {
    const TapedRatios ratios = find_ratios(taped, lane);
    fill_ratios(taped, ratios, row);
    row.status = status_of(taped, ratios, lane);
    ratios_[i] = task_.gears[i] ? ratios.ratio : std::nullopt;
  }
  return fill_powers(i, lane, row);
}

// False where a value is missing that an analysis may have, or may have a reason not to have.
bool TapeSolver::fill_powers(std::size_t i, std::size_t lane, SweepRow& row) {
  const std::optional<PowerTape>& power = tapes_.cases[i].power;
  if (!power) {
    return true;
  }
  if (power->losses && !fill_efficiency(i, lane, row)) {
    return false;
  }
  if (power->largest) {
    const double largest = workspace_.number(*power->largest, lane);
    const double input = workspace_.number(power->input, lane);
    if (!(std::abs(input) > kSameValue * largest)) {
      return false;
    }
    for (const std::size_t column : recirculation_columns_) {
      row.values[column] = input > 0.0 ? largest / input : kNoValue;
    }
  }
  return true;
}

bool TapeSolver::fill_efficiency(std::size_t i, std::size_t lane, SweepRow& row) {
  const LossTape& losses = *tapes_.cases[i].power->losses;
  double largest = read_powers(losses.actuators, lane);
  const Efficiency found = efficiency_of(i, largest);
  const bool names_both = task_.cases[i].names_both_ends();
  const bool is_clear = !names_both || (found.value ? *found.value > kPowerBalance
                                                    : has_clearly_no_efficiency(i, found, largest));
  if (!is_clear ||
      !(std::abs(workspace_.number(losses.imbalance, lane)) <= kPowerBalance * largest)) {
    return false;
  }
  double value = found.value.value_or(kNoValue);
  if (losses.absolute) {
    largest = read_powers(losses.lossless, lane);
    const Efficiency lossless = efficiency_of(i, largest);
    if (!found.value || !lossless.value || !(*lossless.value > kPowerBalance)) {
      return false;
    }
    value = workspace_.number(*losses.absolute, lane);
  }
  for (const std::size_t column : efficiency_columns_) {
    row.values[column] = value;
  }
  if (names_both && !found.value && !efficiency_columns_.empty() && row.status == "solved") {
    row.status = kNoEfficiency;
  }
  return true;
}

// The size of the largest.
double TapeSolver::read_powers(std::span<const std::size_t> cells, std::size_t lane) {
  powers_.clear();
  double largest = 0.0;
  for (const std::size_t cell : cells) {
    powers_.push_back(workspace_.number(cell, lane));
    largest = std::max(largest, std::abs(powers_.back()));
  }
  return largest;
}

Efficiency TapeSolver::efficiency_of(std::size_t i, double largest) const {
  return find_efficiency(task_.mechanism.topology,
                         task_.cases[i],
                         {.actuators = powers_, .loads = no_loads_, .largest = largest});
}

// The largest power of the network is no less than that of the actuators, and it decides what is
// small: whether it is as large or far larger must not matter. Power that does not clearly leave by
// the outputs is left to the whole analysis, which looks for other senses of the losses.
bool TapeSolver::has_clearly_no_efficiency(std::size_t i,
                                           const Efficiency& found,
                                           double largest) const {
  constexpr double kFarLarger = 1e6;
  double out = 0.0;
  for (const int output : task_.cases[i].outputs) {
    out += powers_[static_cast<std::size_t>(output)];
  }
  const Efficiency in_larger = efficiency_of(i, kFarLarger * largest);
  return !found.is_self_locking && !in_larger.value && in_larger.reason == found.reason &&
         out < -kPowerBalance * kFarLarger * largest;
}

}  // namespace kinestat
