#include "studies/shift/gear_values.hpp"

#include <algorithm>
#include <utility>

#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"
#include "mechanism/gears/central_hinge.hpp"
#include "mechanism/gears/planet_load.hpp"
#include "power/rate_ratio.hpp"
#include "studies/shift/shift_solution.hpp"

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
      values_.torques.push_back(torque_of(gear_, e));
      values_.lossy_torques.push_back(lossy_torque_of(gear_, e));
      values_.slips.push_back(slip_of(gear_, e));
    }
    values_.limits = find_limit_uses(gear_);
    values_.bearing = most_loaded(is_bearing);
    values_.mesh = most_loaded(has_teeth);
    return std::move(values_);
  }

 private:
  bool is_solved() const {
    return gear_.motion != nullptr && gear_.motion->status == SolveStatus::solved;
  }

  bool has_actions() const { return gear_.action != nullptr && !gear_.action->magnitudes.empty(); }

  // Whether nothing but the input and the output exchanges power.
  bool balances_as_typed(const StaticSolution& action) const {
    return action.answer.is_exact_input && action.friction.empty() && gear_.which.loads.empty() &&
           plan_.inputs.size() == 1 && plan_.outputs.size() == 1 && plan_.reacting.empty();
  }

  // Where its case has no velocities, the state has the ratio.
  void add_ratios(std::size_t o) {
    const ShiftState& state = gear_.state;
    Case which = gear_.which;
    which.outputs = {plan_.outputs[o]};
    if (plan_.is_hybrid()) {
      which.inputs = {plan_.inputs.front().actuator};
    }
    const StaticSolution* action = has_actions() ? gear_.action : nullptr;
    Ratios ratios;
    if (plan_.is_hybrid() && plan_.has_shares(state.moving)) {
      ratios.reason = "other inputs than the first one move";
    } else if (is_solved()) {
      ratios = find_ratios(gear_.mechanism, which, *gear_.motion, action);
    } else if (const double slow = state.outputs[o].value_or(0.0); slow != 0.0) {
      ratios.ratio = share_of(reference_rate(plan_, state), slow);
      if (action != nullptr) {
        add_torque_ratio(gear_.mechanism, which, *action, ratios);
      }
      // Powers balance, and actions as typed have more digits than the motions of the open train.
      if (ratios.torque_ratio && balances_as_typed(*action)) {
        ratios.ratio = share_of(-1.0, *ratios.torque_ratio);
      }
    }
    values_.ratios.push_back(std::move(ratios));
  }

  // Of several equal planets the most loaded one counts; of central hinges what these leave. One
  // whose force is open might be the most loaded one.
  std::optional<LoadedCoupling> most_loaded(bool (*counts)(CouplingType)) const {
    std::optional<LoadedCoupling> most;
    if (!has_actions()) {
      return most;
    }
    const std::vector<std::optional<CentralHinge>> central = find_central_hinges(gear_.mechanism);
    for (std::size_t e = 0; e < topology_.couplings.size(); ++e) {
      const CouplingTopology& coupling = topology_.couplings[e];
      if (!counts(coupling.type)) {
        continue;
      }
      const std::optional<Vec3> bears =
          borne_force(central[e], CouplingId{static_cast<int>(e)}, [&](CouplingId other) {
            const std::optional<Wrench>& wrench =
                gear_.action->wrenches[static_cast<std::size_t>(other.value)];
            return wrench ? std::optional(wrench->force) : std::nullopt;
          });
      if (!bears) {
        return std::nullopt;
      }
      most = most.value_or(LoadedCoupling{});
      const double force = bears->norm() * most_loaded_share(gear_.mechanism, coupling);
      // Of equal ones the first: rounding decides nothing.
      if (force > most->force * (1.0 + kSameValue)) {
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
