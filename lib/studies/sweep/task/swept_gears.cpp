#include "studies/sweep/task/swept_gears.hpp"

#include <algorithm>
#include <utility>

#include "network/bases.hpp"
#include "studies/shift/shift_network.hpp"
#include "studies/shift/shift_table.hpp"
#include "studies/shift/task/gear_cases.hpp"

namespace kinestat {

namespace {

ShiftNetwork network_of(const Mechanism& mechanism, const ShiftPlan& plan) {
  return make_shift_network(
      mechanism, motion_basis(mechanism.geometry, mechanism.kinematic_order), plan);
}

std::optional<int> find_element(std::string_view name,
                                const Topology& topology,
                                const ShiftPlan& plan) {
  for (std::size_t e = 0; e < plan.elements.size(); ++e) {
    if (topology.actuators[static_cast<std::size_t>(plan.elements[e].actuator)].name == name) {
      return static_cast<int>(e);
    }
  }
  return std::nullopt;
}

// "C1+B2", or none
std::optional<std::vector<int>> elements_of(std::string_view label,
                                            const Topology& topology,
                                            const ShiftPlan& plan) {
  std::vector<int> engaged;
  if (label == kNothingEngaged && !find_element(label, topology, plan)) {
    return engaged;
  }
  while (true) {
    const std::size_t plus = label.find('+');
    const std::optional<int> element = find_element(label.substr(0, plus), topology, plan);
    if (!element) {
      return std::nullopt;
    }
    engaged.push_back(*element);
    if (plus == std::string_view::npos) {
      break;
    }
    label.remove_prefix(plus + 1);
  }
  std::ranges::sort(engaged);
  engaged.erase(std::unique(engaged.begin(), engaged.end()), engaged.end());
  return engaged;
}

}  // namespace

std::optional<NamedShiftState> find_combination(std::string_view label,
                                                const Mechanism& mechanism,
                                                const ShiftPlan& plan) {
  const auto named = std::ranges::find(plan.labels, label, &ShiftLabel::text);
  const std::optional<std::vector<int>> engaged =
      named != plan.labels.end() ? std::optional(named->engaged)
                                 : elements_of(label, mechanism.topology, plan);
  if (!engaged) {
    return std::nullopt;
  }
  return NamedShiftState{.name = std::string(label),
                         .engaged = *engaged,
                         .where = named != plan.labels.end() ? named->where : plan.where,
                         .state = solve_shift_state(network_of(mechanism, plan), plan, *engaged),
                         .reason = {}};
}

std::vector<std::optional<ShiftState>> find_states(
    const std::vector<std::optional<SweptGear>>& gears,
    const Mechanism& mechanism,
    const ShiftPlan& plan) {
  const ShiftNetwork network = network_of(mechanism, plan);
  std::vector<std::optional<ShiftState>> states;
  for (const std::optional<SweptGear>& gear : gears) {
    states.push_back(gear ? std::optional(solve_shift_state(network, plan, gear->state.engaged))
                          : std::nullopt);
  }
  return states;
}

std::optional<Case> described_anew(const SweptGear& gear,
                                   const ShiftState& state,
                                   const ShiftPlan& plan,
                                   const MechanismDescription& description,
                                   const Mechanism& mechanism) {
  NamedShiftState named = gear.state;
  named.state = state;
  GearCase now = gear_case(named, plan);
  if (now == gear.described) {
    return std::nullopt;
  }
  MechanismDescription alone = description;
  alone.cases = describe_gears(description, mechanism.topology, plan, {std::move(now)});
  return bind_described_cases(alone, mechanism).front();
}

void fill_steps(std::span<const SweepColumn> columns,
                double forward,
                std::span<const std::optional<double>> ratios,
                std::span<SweepRow> rows) {
  if (std::ranges::find(columns, SweepColumnKind::step, &SweepColumn::kind) == columns.end()) {
    return;
  }
  std::vector<TableGear> gears;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (ratios[i]) {
      gears.push_back({.state = static_cast<int>(i), .ratio = ratios[i], .engaged = {}});
    }
  }
  sort_gears(gears, forward);
  const ShiftTable table = make_shift_table(gears, forward);
  for (std::size_t g = 0; g < gears.size(); ++g) {
    for (std::size_t q = 0; q < columns.size(); ++q) {
      if (columns[q].kind == SweepColumnKind::step && table.steps[g]) {
        rows[static_cast<std::size_t>(gears[g].state)].values[q] = *table.steps[g];
      }
    }
  }
}

}  // namespace kinestat
