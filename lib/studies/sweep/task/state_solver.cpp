#include "studies/sweep/task/state_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cases/solve_cases.hpp"
#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "mechanism/bind/bind.hpp"
#include "studies/sweep/state_rules.hpp"
#include "studies/sweep/task/row_status.hpp"
#include "studies/sweep/task/sweep_samples.hpp"

namespace kinestat {

namespace {

Expression number_in(double count, const std::string& unit) {
  auto parsed =
      parse_expression(unit.empty() ? fmt::format("{}", count) : fmt::format("{} {}", count, unit));
  KINESTAT_EXPECTS(std::holds_alternative<Expression>(parsed));
  return std::get<Expression>(std::move(parsed));
}

// As it would be typed, so that 180 deg is half a turn and no rounding of it; in SI where that
// alone gives the number.
Expression expression_of(const SweepAxis& axis, std::uint64_t place) {
  const Quantity value = axis.value_at(place);
  Expression typed = number_in(axis.count_at(place), axis.unit());
  const auto evaluated = evaluate(typed, no_names);
  const auto* same = std::get_if<Quantity>(&evaluated);
  return same != nullptr && same->value == value.value && same->dimension == value.dimension
             ? typed
             : number_in(value.value, is_bare(value.dimension) ? "" : si_unit_of(value.dimension));
}

// One that the case does not have is a NaN. `columns` are those of the task in the mechanism.
void fill_row(const std::vector<SweepColumn>& columns,
              const Mechanism& mechanism,
              const CaseAnalysis& one,
              const FileUnits& units,
              SweepRow& row) {
  for (std::size_t q = 0; q < row.values.size(); ++q) {
    const double value = value_of(columns[q], one, mechanism, units).value_or(kNoValue);
    row.values[q] = std::isfinite(value) ? value : kNoValue;
  }
}

}  // namespace

StateBinder::StateBinder(const SweepTask& task) : task_(task), description_(task.description) {}

std::optional<Mechanism> StateBinder::bind(std::uint64_t state) {
  for (std::size_t a = 0; a < task_.plan.axes().size(); ++a) {
    const SweepAxis& axis = task_.plan.axes()[a];
    Value& value = description_.parameters[static_cast<std::size_t>(axis.parameter())].value;
    value.expression = expression_of(axis, task_.plan.place_of(state, a));
    value.text_column = 0;
  }
  Diagnostics found;
  std::optional<Mechanism> mechanism = task_.has_motion_alone
                                           ? bind_unassembled(description_, found)
                                           : kinestat::bind(description_, found);
  const auto error = std::ranges::find(found.items(), Severity::error, &Diagnostic::severity);
  code_ = error == found.items().end() ? "E0316" : error->code;
  return mechanism;
}

double largest_known(const SweepTask& task, const Case& which) {
  double largest = 0.0;
  const auto add = [&](SweepColumnKind kind, const std::vector<Primary>& primaries) {
    if (std::ranges::find(task.columns, kind, &SweepColumn::kind) != task.columns.end()) {
      for (const Primary& one : primaries) {
        largest = std::max(largest, std::abs(one.value));
      }
    }
  };
  add(SweepColumnKind::rate, which.motions);
  add(SweepColumnKind::action, which.actions);
  return largest;
}

std::optional<double> gear_ratio(const SweepTask& task, std::size_t row, const CaseAnalysis& one) {
  return task.gears[row] && one.ratios ? one.ratios->ratio : std::nullopt;
}

// Whether a value is so far from the others, from what the case knows, or a ratio from one, that it
// may be made of what rounding left.
bool may_be_rounding(const SweepTask& task, const Case& which, const SweepRow& row) {
  double largest = largest_known(task, which);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t q = 0; q < row.values.size(); ++q) {
    const SweepColumnKind kind = task.columns[q].kind;
    const double size = std::abs(row.values[q]);
    if (size > 0.0) {  // which no value is not
      largest = std::max(largest, size);
      least = std::min(least, size);
    }
    if (kind == SweepColumnKind::ratio || kind == SweepColumnKind::torque_ratio) {
      largest = std::max(largest, 1.0);
      least = std::min(least, 1.0);
    }
  }
  return least < kSameValue * largest;
}

StateSolver::StateSolver(const SweepTask& task, std::size_t lanes)
    : task_(task), binder_(task), states_(task.cases.size()) {
  if (task.motion) {
    moved_.emplace(*task.motion, task.columns);
  }
  if (task.has_motion_alone && lanes > 1) {
    lanes_ = LaneMotions::make(
        task.description, task.mechanism, *task.motion, varying_parameters(task.plan));
    if (lanes_) {
      lane_rules_ = std::make_shared<const StateRules>(task.plan, task.description);
    }
  }
  const std::size_t together = task.tapes ? lanes : lanes_ ? kMotionLanes : 1;
  if (task.tapes) {
    taped_.emplace(task, *task.tapes, together);
  }
  is_undefined_.resize(together);
  is_answered_.resize(together);
  places_.resize(together * task.plan.axes().size());
  rows_.resize(together * task.cases.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i].which = i % task.cases.size();
    rows_[i].values.assign(task.columns.size(), kNoValue);
  }
  for (std::size_t lane = 0; lane < together; ++lane) {
    solved_.push_back({.number = 0, .places = places_of(lane), .rows = rows_of(lane)});
  }
}

std::span<std::uint64_t> StateSolver::places_of(std::size_t lane) {
  const std::size_t axes = task_.plan.axes().size();
  return std::span(places_).subspan(lane * axes, axes);
}

std::span<SweepRow> StateSolver::rows_of(std::size_t lane) {
  return std::span(rows_).subspan(lane * task_.cases.size(), task_.cases.size());
}

std::span<const SolvedState> StateSolver::solve_next(StateWalk& walk) {
  std::size_t count = 0;
  while (count < is_undefined_.size() && walk.next()) {
    const std::uint64_t together = taped_ ? taped_->takes(walk) : 1;
    const std::size_t some = std::min<std::uint64_t>(together, is_undefined_.size() - count);
    take(walk, count, some);
    walk.pass(some - 1);
    count += some;
  }
  if (count > 0) {
    answer_together(count);
  }
  for (std::size_t lane = 0; lane < count; ++lane) {
    if (is_answered_[lane] == 0) {
      analyse(lane);
    }
  }
  if ((taped_ || lanes_) && count > 0) {
    check_some(count);
  }
  return std::span(solved_).first(count);
}

void StateSolver::answer_together(std::size_t count) {
  if (taped_) {
    taped_->play();
    taped_->fill(count, rows_);
  }
  if (lanes_) {
    lanes_->follow();
  }
  for (std::size_t lane = 0; lane < count; ++lane) {
    const bool has_answer = is_undefined_[lane] == 0 &&
                            (taped_ ? taped_->has_answer(lane)
                                    : lanes_ && is_answered_[lane] != 0 &&
                                          lanes_->fill(lane, task_.columns, rows_of(lane).front()));
    is_answered_[lane] = has_answer ? 1 : 0;
  }
}

// The state of the walk, and as many that are alike as make up the count.
void StateSolver::take(const StateWalk& walk, std::size_t lane, std::size_t count) {
  if (taped_ && !walk.is_undefined()) {
    taped_->load(walk, lane, count);
  }
  if (lanes_) {
    const bool is_right = !walk.is_undefined() && lane_rules_->hold(walk.slots(), scratch_);
    is_answered_[lane] = is_right && lanes_->load(lane, walk.slots()) ? 1 : 0;
  }
  const std::span<const std::uint64_t> from = walk.places();
  std::uint64_t* place = places_of(lane).data();
  for (std::size_t i = 0; i < count; ++i) {
    solved_[lane + i].number = walk.state() + i;
    is_undefined_[lane + i] = walk.is_undefined() ? 1 : 0;
    for (std::size_t a = 0; a < from.size(); ++a) {
      *place++ = from[a] + (a + 1 == from.size() ? i : 0);
    }
  }
}

void StateSolver::analyse(std::size_t lane) {
  analyse(solved_[lane].number, is_undefined_[lane] != 0, rows_of(lane));
}

void StateSolver::analyse(std::uint64_t state, bool is_undefined, std::span<SweepRow> rows) {
  const std::optional<Mechanism> mechanism = binder_.bind(state);
  // A requirement alone may have no answer; then none of the numbers counts.
  if (!mechanism || is_undefined) {
    clear(binder_.code(), rows);
    return;
  }
  if (task_.has_motion_alone) {
    clear("solved", rows);
  } else {
    solve_position(*mechanism, rows);
  }
  if (moved_) {
    moved_->fill(binder_.description(), *mechanism, rows);
  }
}

// The mechanism as it is drawn.
void StateSolver::solve_position(const Mechanism& mechanism, std::span<SweepRow> rows) {
  std::vector<Case> cases = chosen_cases(task_, mechanism);
  if (task_.shift) {
    decide_gears(mechanism, cases);
  }
  const Topology& topology = task_.mechanism.topology;
  const std::vector<SweepColumn> columns =
      has_same_magnitudes(topology, mechanism.topology)
          ? task_.columns
          : columns_in(task_.columns, topology, mechanism.topology);
  std::vector<std::optional<double>> ratios(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::ranges::fill(rows[i].values, kNoValue);
    if (states_[i] && states_[i]->kind != ShiftClass::gear) {
      rows[i].status = word_of(states_[i]->kind);
      continue;
    }
    const std::span<const Case> which(&cases[i], 1);
    CaseAnalysis one = solve_some_cases(mechanism, which).front();
    fill_row(columns, mechanism, one, task_.description.units, rows[i]);
    if (may_be_rounding(task_, cases[i], rows[i])) {
      one = solve_again(mechanism, i, cases[i]);
      fill_row(columns, mechanism, one, task_.description.units, rows[i]);
    }
    fill_limit_use(mechanism, i, one, rows[i]);
    rows[i].status = row_status(one, task_, mechanism, task_.is_usually_solved[i]);
    ratios[i] = gear_ratio(task_, i, one);
  }
  fill_steps(task_.columns, task_.forward, ratios, rows);
}

// With bounds. A gear is decided anew by the state, and is no case of the description.
CaseAnalysis StateSolver::solve_again(const Mechanism& mechanism,
                                      std::size_t row,
                                      const Case& which) {
  return task_.gears[row]
             ? solve_some_cases(mechanism, std::span(&which, 1), {.accuracy = Accuracy::automatic})
                   .front()
             : solve_certified_case(binder_.description(), mechanism, task_.chosen[row], which);
}

void StateSolver::decide_gears(const Mechanism& mechanism, std::vector<Case>& cases) {
  plan_ = bind_shift(binder_.description(), mechanism.topology);
  KINESTAT_EXPECTS(plan_.has_value());
  states_ = find_states(task_.gears, mechanism, *plan_);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!states_[i] || states_[i]->kind != ShiftClass::gear) {
      continue;
    }
    if (std::optional<Case> anew = described_anew(
            *task_.gears[i], *states_[i], *plan_, binder_.description(), mechanism)) {
      anew->asks_actions = anew->asks_actions && task_.has_statics;
      cases[i] = *std::move(anew);
    }
  }
}

// With the limits of the state, which may follow from its parameters.
void StateSolver::fill_limit_use(const Mechanism& mechanism,
                                 std::size_t row,
                                 const CaseAnalysis& one,
                                 SweepRow& filled) const {
  if (!states_[row]) {
    return;
  }
  for (std::size_t q = 0; q < filled.values.size(); ++q) {
    if (task_.columns[q].kind == SweepColumnKind::limit_use) {
      filled.values[q] = limit_use_of(mechanism, *plan_, *states_[row], one).value_or(kNoValue);
    }
  }
}

// Now and then a state is analysed both ways, so that no mistake of a tape or of what is followed
// in lanes stays unseen.
void StateSolver::check_some(std::size_t count) {
  constexpr std::uint64_t kCheckEvery = 100003;  // takes a tenth of the time that tapes take
  if (unchecked_ >= count) {
    unchecked_ -= count;
    return;
  }
  const auto lane = static_cast<std::size_t>(unchecked_);
  if (is_answered_[lane] != 0) {
    check_answer(solved_[lane].number, rows_of(lane));
  }
  unchecked_ = kCheckEvery - (count - lane);
}

void StateSolver::check_answer(std::uint64_t state, std::span<const SweepRow> answered) {
  std::vector<SweepRow> rows(answered.begin(), answered.end());
  analyse(state, false, rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    double largest = 0.0;
    for (const double value : rows[i].values) {
      largest = std::isnan(value) ? largest : std::max(largest, std::abs(value));
    }
    for (std::size_t q = 0; q < rows[i].values.size(); ++q) {
      const double a = rows[i].values[q];
      const double b = answered[i].values[q];
      KINESTAT_EXPECTS(std::isnan(a) == std::isnan(b) &&
                       (std::isnan(a) || std::abs(a - b) <= kReportsAgree * largest));
    }
    KINESTAT_EXPECTS(rows[i].status == answered[i].status);
  }
}

void StateSolver::clear(std::string_view status, std::span<SweepRow> rows) {
  for (SweepRow& row : rows) {
    row.status = status;
    std::ranges::fill(row.values, kNoValue);
  }
}

}  // namespace kinestat
