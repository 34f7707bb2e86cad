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
         std::ranges::equal(a.actions, b.actions, is_same) &&
         std::ranges::equal(a.other_flanks, b.other_flanks, [&](const auto& x, const auto& y) {
           return is_same(x.screw, y.screw);
         });
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

std::vector<SweepSample> find_samples(const SweepTask& task) {
  std::vector<SweepSample> samples;
  StateBinder binder(task);
  for (const std::uint64_t state : sample_states(task.plan)) {
    if (std::optional<Mechanism> whole = binder.bind(state)) {
      samples.push_back({.slots = slots_at(task.plan, state), .mechanism = *std::move(whole)});
    }
  }
  return samples;
}

bool rebinds(Rebinder& rebinder, const SweepTask& task, std::span<const SweepSample> samples) {
  Geometry geometry = task.mechanism.geometry;
  return std::ranges::all_of(samples, [&](const SweepSample& sample) {
    return !rebinder.rebind_geometry(sample.slots, geometry) ||
           has_same_screws(geometry, sample.mechanism.geometry);
  });
}

}  // namespace kinestat
