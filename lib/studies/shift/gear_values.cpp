#include "studies/shift/gear_values.hpp"

#include <algorithm>
#include <utility>

#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"

namespace kinestat {

namespace {

bool is_bearing(CouplingType type) {
  return kind_of(type).is_bearing;
}

class GearReader {
 public:
  explicit GearReader(const SolvedGear& gear)
      : gear_(gear), plan_(gear.plan), topology_(gear.mechanism.topology) {}

  GearValues run() {
    for (std::size_t o = 0; o < plan_.outputs.size(); ++o) {
      add_ratios(o);
    }
    for (std::size_t e = 0; e < plan_.elements.size(); ++e) {
      add_element(e);
    }
    values_.bearing = most_loaded(is_bearing);
    values_.mesh = most_loaded(has_teeth);
    return std::move(values_);
  }

 private:
  const ActuatorTopology& actuator(int index) const {
    return topology_.actuators[static_cast<std::size_t>(index)];
  }

  bool is_solved() const {
    return gear_.motion != nullptr && gear_.motion->status == SolveStatus::solved;
  }

  bool has_actions() const { return gear_.action != nullptr && !gear_.action->magnitudes.empty(); }

  // Where a gear leaves freedoms beside it, its case has no velocities; the state has the ratio.
  void add_ratios(std::size_t o) {
    const ShiftState& state = gear_.state.state;
    Case which = gear_.which;
    which.outputs = {plan_.outputs[o]};
    const StaticSolution* action = has_actions() ? gear_.action : nullptr;
    Ratios ratios;
    if (is_solved()) {
      ratios = find_ratios(gear_.mechanism, which, *gear_.motion, action);
    } else if (const double slow = state.outputs[o].value_or(0.0); slow != 0.0) {
      ratios.ratio = state.inputs.front() / slow;
      if (action != nullptr) {
        add_torque_ratio(gear_.mechanism, which, *action, ratios);
      }
    }
    values_.ratios.push_back(std::move(ratios));
  }

  void add_element(std::size_t e) {
    const ActuatorTopology& element = actuator(plan_.elements[e].actuator);
    const auto action = static_cast<std::size_t>(element.action);
    const auto freedom = static_cast<std::size_t>(element.freedom);
    values_.torques.push_back(has_actions() ? gear_.action->magnitudes[action] : std::nullopt);
    values_.lossy_torques.push_back(gear_.lossy_actions != nullptr ? (*gear_.lossy_actions)[action]
                                                                   : std::nullopt);
    values_.slips.push_back(is_solved() ? std::optional(gear_.motion->rates[freedom])
                                        : gear_.state.state.slips[e]);
  }

  // How many equal planets share what a coupling bears.
  int planets_of(const CouplingTopology& coupling) const {
    const std::vector<int>& counts = gear_.mechanism.planet_counts;
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
    for (std::size_t e = 0; e < topology_.couplings.size(); ++e) {
      const CouplingTopology& coupling = topology_.couplings[e];
      const int planets = planets_of(coupling);
      const bool may_cancel =
          planets == 1 && is_bearing(coupling.type) && has_planets(gear_.mechanism);
      if (!counts(coupling.type) || may_cancel || !gear_.action->wrenches[e]) {
        continue;
      }
      const double force = gear_.action->wrenches[e]->force.norm() / planets;
      // Of equal ones the first: rounding decides nothing.
      if (force > (most ? most->force * (1.0 + kSameValue) : 0.0)) {
        most = {.name = coupling.name, .force = force};
      }
    }
    return most;
  }

  const SolvedGear& gear_;
  const ShiftPlan& plan_;
  const Topology& topology_;
  GearValues values_;
};

}  // namespace

GearValues find_gear_values(const SolvedGear& gear) {
  return GearReader(gear).run();
}

}  // namespace kinestat
