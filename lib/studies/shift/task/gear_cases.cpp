#include "studies/shift/task/gear_cases.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"
#include "network/bases.hpp"
#include "studies/shift/gear_limits.hpp"
#include "studies/shift/task/slip_findings.hpp"

namespace kinestat {

namespace {

void add_unless(const std::vector<int>& known, int index, std::vector<int>& list) {
  if (std::ranges::find(known, index) == known.end()) {
    list.push_back(index);
  }
}

void complain_of_length(const ShiftAnalysis& shift, Diagnostics& found) {
  found.error("E0711",
              shift.plan.where,
              fmt::format("{} elements have {:.0f} combinations, more than the {:.0f} of a table",
                          shift.plan.elements.size(),
                          shift.solution.asked,
                          kMostCombinations),
              fmt::format("a gear engages {} of them; name only the elements between which you "
                          "choose, and give the others as cases",
                          shift.solution.needed));
}

void warn_of_missing_elements(const ShiftAnalysis& shift, Diagnostics& found) {
  found.warning(
      "W0711",
      shift.plan.where,
      fmt::format("a gear engages {} elements (net degree of freedom {}, {}), and 'shift' "
                  "names {}",
                  shift.solution.needed,
                  shift.solution.net_freedom,
                  counted(shift.plan.inputs.size(), "input"),
                  shift.plan.elements.size()),
      "add clutches or brakes to 'elements', or a coupling that holds what is still free: "
      "'kinestat mobility' lists the freedoms");
}

// Geometry tells what a planet is.
void refuse_limits_of_no_planet(const ShiftPlan& plan,
                                const Mechanism& mechanism,
                                Diagnostics& found) {
  const std::vector<LimitedPart> parts = find_limited_parts(mechanism, plan);
  for (const ShiftLimit& limit : plan.limits) {
    const bool has_part = std::ranges::any_of(
        parts, [&](const LimitedPart& part) { return part.limit.where == limit.where; });
    if (!has_part) {
      found.error(
          "E0305",
          limit.where,
          limit.index < 0
              ? std::string("'planet_speed' of 'limits' holds for planets, and there are none")
              : fmt::format("'planet_speed' of 'limits' names '{}', which is not a planet",
                            mechanism.topology.body(BodyId{limit.index}).name),
          "a planet is a gear that nothing but its teeth and a moving carrier holds; limit "
          "another body with 'speed'");
    }
  }
}

}  // namespace

GearCase gear_case(const NamedShiftState& state, const ShiftPlan& plan) {
  GearCase gear{.label = state.name,
                .where = state.where,
                .moving = state.state.moving,
                .engaged = {},
                .open = {},
                .others = {}};
  for (int o = 0; o < static_cast<int>(plan.others.size()); ++o) {
    const bool reacts = std::ranges::any_of(state.state.reactions, [&](const ShiftReaction& one) {
      return one.other == o && !one.torque_shares.empty();
    });
    if (!reacts) {
      add_unless(state.state.unloaded_others, o, gear.others);
    }
  }
  const std::vector<int> holding = state.holding();
  for (int e = 0; e < static_cast<int>(plan.elements.size()); ++e) {
    if (!std::ranges::binary_search(holding, e)) {
      add_unless(state.state.unloaded, e, gear.open);
    } else {
      add_unless(state.state.surplus, e, gear.engaged);
    }
  }
  return gear;
}

void add_gear_cases(const std::vector<GearCase>& gears,
                    const ShiftPlan& plan,
                    MechanismDescription& description,
                    Mechanism& mechanism) {
  MechanismDescription alone = description;
  alone.cases = describe_gears(description, mechanism.topology, plan, gears);
  std::ranges::move(bind_described_cases(alone, mechanism), std::back_inserter(mechanism.cases));
  std::ranges::move(alone.cases, std::back_inserter(description.cases));
}

std::optional<ShiftAnalysis> add_gears(MechanismDescription& description,
                                       Mechanism& mechanism,
                                       const ShiftOptions& options,
                                       Diagnostics& found) {
  std::optional<ShiftPlan> plan = bind_shift(description, mechanism.topology);
  if (!plan) {
    return std::nullopt;
  }
  const int errors_before = found.error_count();
  refuse_limits_of_no_planet(*plan, mechanism, found);
  if (found.error_count() > errors_before) {
    return std::nullopt;
  }
  const CoordinateBasis basis = motion_basis(mechanism.geometry, mechanism.kinematic_order);
  ShiftAnalysis shift{.plan = *plan,
                      .solution = find_shift_solution(mechanism, basis, *plan, options)};
  if (shift.solution.is_too_long) {
    complain_of_length(shift, found);
    return std::nullopt;
  }
  if (shift.solution.needed > static_cast<int>(shift.plan.elements.size())) {
    warn_of_missing_elements(shift, found);
  }
  add_slips(description, mechanism, shift, found);
  std::vector<GearCase> gears;
  for (const NamedShiftState& one : shift.solution.states) {
    if (one.state.kind == ShiftClass::gear) {
      gears.push_back(gear_case(one, shift.plan));
    }
  }
  add_gear_cases(gears, shift.plan, description, mechanism);
  return shift;
}

}  // namespace kinestat
