#include "studies/sweep/sweep_plan.hpp"

#include <algorithm>
#include <utility>

#include "core/contract.hpp"
#include "expression/exact.hpp"
#include "mechanism/gears/planet_question.hpp"

namespace kinestat {

SweepPlan::SweepPlan(const MechanismDescription& description) {
  KINESTAT_EXPECTS(description.sweep.has_value());
  add_axes(description);
  count_states(description);
  add_dependents(description);
  add_requirements(description);
}

// Strides of 1 give every axis the place that is the number of the state.
void SweepPlan::run_through(std::span<const double> rows) {
  KINESTAT_EXPECTS(!axes_.empty() && rows.size() % axes_.size() == 0);
  state_count_ = rows.size() / axes_.size();
  is_product_ = false;
  draw_.reset();
  std::ranges::fill(strides_, 1);
  for (std::size_t a = 0; a < axes_.size(); ++a) {
    std::vector<double> counts;
    counts.reserve(state_count_);
    for (std::size_t i = a; i < rows.size(); i += axes_.size()) {
      counts.push_back(rows[i]);
    }
    axes_[a].run_through(std::move(counts));
  }
}

void SweepPlan::add_axes(const MechanismDescription& description) {
  const std::vector<Parameter> parameters = parameters_of(description);
  const BasicParameterTable<Exact> exact = evaluate_parameters<Exact>(parameters).table;
  depths_.assign(parameters.size(), -1);
  for (const VariedParameter& varied : description.sweep->vary) {
    const int depth = static_cast<int>(axes_.size());
    axes_.emplace_back(description, varied, exact);
    depths_[static_cast<std::size_t>(axes_.back().parameter())] = depth;
  }
}

void SweepPlan::count_states(const MechanismDescription& description) {
  strides_.assign(axes_.size(), 1);
  if (description.sweep->sample) {
    const SampleChoice choice = sample_choice(description);
    draw_.emplace(choice, axes_.size());
    state_count_ = choice.count;
    is_product_ = false;
    return;
  }
  for (std::size_t i = axes_.size(); i > 0; --i) {
    strides_[i - 1] = state_count_;
    state_count_ *= axes_[i - 1].size();
  }
}

void SweepPlan::add_dependents(const MechanismDescription& description) {
  const std::vector<Parameter> parameters = parameters_of(description);
  const ParameterTable table = evaluate_parameters(parameters).table;
  for (const Parameter& parameter : parameters) {
    const Quantity* value = table.find(parameter.name);
    slots_.values.push_back(value != nullptr ? *value : Quantity{});
    slots_.has_value.push_back(value != nullptr);
  }
  const auto slot_of = [&](const std::string& name) { return table.index_of(name); };
  for (const int i : evaluation_order(parameters)) {
    int& depth = depths_[static_cast<std::size_t>(i)];
    if (depth >= 0) {
      continue;  // varied: what the file gives for it does not count
    }
    SlotExpression value(parameters[static_cast<std::size_t>(i)].value, slot_of);
    depth = depth_of(value.slots());
    if (depth >= 0) {
      dependents_.push_back({.parameter = i, .value = std::move(value), .depth = depth});
    }
  }
}

void SweepPlan::add_requirements(const MechanismDescription& description) {
  const std::vector<Parameter> parameters = parameters_of(description);
  const ParameterTable table(parameters);
  for (const Requirement& one : description.sweep->require) {
    const auto slot_of = [&](const std::string& name) { return table.index_of(name); };
    const auto answer_of = [&](const ConditionQuestion& question) {
      auto asked = PlanetQuestion::make(question.word, question.of, description);
      KINESTAT_EXPECTS(std::holds_alternative<PlanetQuestion>(asked));  // or its check complained
      return std::get<PlanetQuestion>(asked).with_slots(slot_of);
    };
    SlotCondition condition(one.condition, slot_of, answer_of);
    const int depth = depth_of(condition.slots());
    requirements_.push_back(
        {.text = one.condition.text(), .condition = std::move(condition), .depth = depth});
  }
}

void SweepPlan::evaluate_dependents(int axis, Slots& slots, std::vector<Quantity>& scratch) const {
  for (const DependentParameter& one : dependents_) {
    if (one.depth >= axis) {
      const auto slot = static_cast<std::size_t>(one.parameter);
      const std::optional<Quantity> value = one.value.evaluate(slots, scratch);
      slots.values[slot] = value.value_or(Quantity{});
      slots.has_value[slot] = value.has_value();
    }
  }
}

int SweepPlan::depth_of(std::span<const int> slots) const {
  int depth = -1;
  for (const int slot : slots) {
    depth = std::max(depth, depths_[static_cast<std::size_t>(slot)]);
  }
  return depth;
}

// Small enough that what an interruption loses is little and that shards are alike; large enough
// that the files of chunks stay few.
std::uint64_t SweepPlan::chunk_size() const {
  constexpr std::uint64_t kUsualCount = 256;
  constexpr std::uint64_t kSmallest = 16;
  constexpr std::uint64_t kLargest = 4096;
  constexpr std::uint64_t kMostChunks = 65536;
  const std::uint64_t usual = std::clamp(state_count_ / kUsualCount, kSmallest, kLargest);
  return std::max(usual, state_count_ / kMostChunks + 1);
}

std::uint64_t SweepPlan::chunk_count() const {
  return (state_count_ + chunk_size() - 1) / chunk_size();
}

}  // namespace kinestat
