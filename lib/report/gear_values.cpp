#include "report/gear_values.hpp"

#include <algorithm>

#include "core/contract.hpp"
#include "report/ratio_in_units.hpp"

namespace kinestat {

namespace {

bool is_mesh(CouplingType type) {
  using enum CouplingType;
  return type == gear || type == bevel_gear || type == worm || type == rack;
}

bool is_bearing(CouplingType type) {
  using enum CouplingType;
  return type == revolute || type == cylindrical || type == spherical || type == universal ||
         type == prismatic;
}

class GearReader {
 public:
  GearReader(const Analysis& analysis, std::size_t state)
      : analysis_(analysis),
        plan_(analysis.shift->plan),
        state_(analysis.shift->solution.states[state]),
        one_(*find_gear_case(analysis, state_)),
        in_(analysis.description.units) {
    values_.step = analysis.shift->solution.table.steps[state];
  }

  GearValues run() {
    for (std::size_t o = 0; o < plan_.outputs.size(); ++o) {
      add_ratios(o);
    }
    for (std::size_t e = 0; e < plan_.elements.size(); ++e) {
      add_element(e);
    }
    if (one_.power_graph) {
      values_.recirculation = one_.power_graph->factor;
    }
    values_.bearing = most_loaded(is_bearing);
    values_.mesh = most_loaded(is_mesh);
    return std::move(values_);
  }

 private:
  const ActuatorTopology& actuator(int index) const {
    return analysis_.mechanism.topology.actuators[static_cast<std::size_t>(index)];
  }

  bool is_solved() const { return one_.motion && one_.motion->status == SolveStatus::solved; }

  bool has_actions() const { return one_.action && !one_.action->magnitudes.empty(); }

  // Where a gear leaves freedoms beside it, its case has no velocities; the state has the ratio.
  void add_ratios(std::size_t o) {
    Case which = one_.which;
    which.outputs = {plan_.outputs[o]};
    Ratios ratios;
    if (is_solved()) {
      ratios = find_ratios(
          analysis_.mechanism, which, *one_.motion, has_actions() ? &*one_.action : nullptr);
    } else if (const double slow = state_.state.outputs[o].value_or(0.0); slow != 0.0) {
      ratios.ratio = state_.state.inputs.front() / slow;
      ratios.torque_ratio = torque_ratio_to(plan_.outputs[o]);
    }
    const RatiosInUnits shown =
        ratios_in_units(ratios, which, analysis_.mechanism, analysis_.description.units);
    values_.ratios.push_back(shown.ratio.value);
    values_.torque_ratios.push_back(shown.torque_ratio.value);
    values_.reasons.push_back(ratios.reason);
  }

  // The actions of all inputs over that of the output.
  std::optional<double> torque_ratio_to(int output) const {
    if (!has_actions()) {
      return std::nullopt;
    }
    double sum = 0.0;
    for (const ShiftInput& input : plan_.inputs) {
      const std::optional<double> action = action_of(input.actuator);
      if (!action) {
        return std::nullopt;
      }
      sum += *action;
    }
    const std::optional<double> out = action_of(output);
    return out && *out != 0.0 ? std::optional(sum / *out) : std::nullopt;
  }

  std::optional<double> action_of(int index) const {
    const int action = actuator(index).action;
    return is_by_convention(*one_.action, action)
               ? std::nullopt
               : one_.action->magnitudes[static_cast<std::size_t>(action)];
  }

  void add_element(std::size_t e) {
    const ActuatorTopology& element = actuator(plan_.elements[e].actuator);
    const auto action = static_cast<std::size_t>(element.action);
    const auto freedom = static_cast<std::size_t>(element.freedom);
    const std::optional<double> torque =
        has_actions() ? one_.action->magnitudes[action] : std::nullopt;
    const std::optional<double> slip =
        is_solved() ? std::optional(one_.motion->rates[freedom]) : state_.state.slips[e];
    values_.torques.push_back(torque ? std::optional(in_.action(*torque, true)) : std::nullopt);
    values_.slips.push_back(slip ? std::optional(in_.rate(*slip, true)) : std::nullopt);
  }

  // How many equal planets share what a coupling bears.
  int planets_of(const CouplingTopology& coupling) const {
    const std::vector<int>& counts = analysis_.mechanism.planet_counts;
    return counts.empty() || coupling.action_count == 0
               ? 1
               : std::max(1, counts[static_cast<std::size_t>(coupling.first_action)]);
  }

  // The forces of one planet count where several share a load. Then bearings that no planet shares
  // do not: on the main axis the forces of equal planets cancel, which the solution does not know.
  std::optional<LoadedCoupling> most_loaded(bool (*counts)(CouplingType)) const {
    std::optional<LoadedCoupling> most;
    if (!has_actions()) {
      return most;
    }
    const Topology& topology = analysis_.mechanism.topology;
    for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
      const CouplingTopology& coupling = topology.couplings[e];
      const int planets = planets_of(coupling);
      const bool may_cancel =
          planets == 1 && is_bearing(coupling.type) && has_planets(analysis_.mechanism);
      if (!counts(coupling.type) || may_cancel || !one_.action->wrenches[e]) {
        continue;
      }
      const double force = in_.force(one_.action->wrenches[e]->force.norm()) / planets;
      if (force > (most ? most->force : 0.0)) {
        most = {.name = topology.couplings[e].name, .force = force};
      }
    }
    return most;
  }

  const Analysis& analysis_;
  const ShiftPlan& plan_;
  const NamedShiftState& state_;
  const CaseAnalysis& one_;
  InUnits in_;
  GearValues values_;
};

}  // namespace

const CaseAnalysis* find_gear_case(const Analysis& analysis, const NamedShiftState& state) {
  if (state.state.kind != ShiftClass::gear) {
    return nullptr;
  }
  const auto at = std::ranges::find(
      analysis.cases, state.name, [](const CaseAnalysis& one) { return one.which.label; });
  KINESTAT_EXPECTS(at != analysis.cases.end());
  return &*at;
}

GearValues gear_values(const Analysis& analysis, std::size_t state) {
  return GearReader(analysis, state).run();
}

}  // namespace kinestat
