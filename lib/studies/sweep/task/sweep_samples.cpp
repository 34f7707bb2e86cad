#include "studies/sweep/task/sweep_samples.hpp"

#include <algorithm>
#include <utility>

#include "studies/sweep/task/state_solver.hpp"
#include "studies/sweep/task/sweep_task.hpp"

namespace kinestat {

namespace {

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

bool has_same_screws(const Geometry& a, const Geometry& b) {
  const auto is_same = [](const auto& x, const auto& y) {
    return x.coordinates() == y.coordinates();
  };
  return std::ranges::equal(a.motions, b.motions, is_same) &&
         std::ranges::equal(a.actions, b.actions, is_same);
}

}  // namespace

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

Slots slots_at(const SweepPlan& plan, std::uint64_t state) {
  Slots slots = plan.slots();
  for (std::size_t i = 0; i < plan.axes().size(); ++i) {
    const SweepAxis& axis = plan.axes()[i];
    const auto slot = static_cast<std::size_t>(axis.parameter());
    slots.values[slot] = axis.value_at(plan.place_of(state, i));
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

std::optional<std::vector<SweepSample>> find_samples(const SweepTask& task, Rebinder& rebinder) {
  std::vector<SweepSample> samples;
  StateBinder binder(task);
  for (const std::uint64_t state : sample_states(task.plan)) {
    SweepSample sample{.slots = slots_at(task.plan, state), .geometry = task.mechanism.geometry};
    const std::optional<Mechanism> whole = binder.bind(state);
    if (!whole || !rebinder.rebind_geometry(sample.slots, sample.geometry)) {
      continue;
    }
    if (!has_same_screws(sample.geometry, whole->geometry)) {
      return std::nullopt;
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

}  // namespace kinestat
