#include "power/power_record.hpp"

#include "core/tolerance.hpp"
#include "power/internal/efficiency_record.hpp"
#include "power/internal/power_graph_record.hpp"

namespace kinestat {

namespace {

void emit_into_heads(const PowerView& v, const EachNumber& each) {
  for (std::size_t e = 0; e < v.flow.into_head.size(); ++e) {
    each(v.mechanism.topology.couplings[e].name, v.flow.into_head[e], QuantityKind::power);
  }
}

void emit_supplied(const PowerView& v, const EachNumber& each) {
  for (std::size_t e = 0; e < v.flow.supplied.size(); ++e) {
    each(v.mechanism.topology.couplings[e].name, v.flow.supplied[e], QuantityKind::power);
  }
}

void emit_actuators(const PowerView& v, const EachNumber& each) {
  for (std::size_t i = 0; i < v.flow.actuators.size(); ++i) {
    each(v.mechanism.topology.actuators[i].name, v.flow.actuators[i], QuantityKind::power);
  }
}

void emit_loads(const PowerView& v, const EachNumber& each) {
  for (std::size_t i = 0; i < v.flow.loads.size(); ++i) {
    each(v.which.loads[i].name, v.flow.loads[i], QuantityKind::power);
  }
}

void emit_friction(const PowerView& v, const EachNumber& each) {
  for (std::size_t i = 0; i < v.flow.friction.size(); ++i) {
    const CouplingId coupling = v.action.friction[i].coupling;
    each(v.mechanism.topology.coupling(coupling).name, v.flow.friction[i], QuantityKind::power);
  }
}

// Of the inputs that the case names.
std::vector<std::string> absorbing_inputs(const PowerView& v) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name, double power) {
    if (power < -kPowerBalance * v.flow.largest) {
      names.push_back(name);
    }
  };
  for (const int i : v.which.inputs) {
    const auto a = static_cast<std::size_t>(i);
    add(v.mechanism.topology.actuators[a].name, v.flow.actuators[a]);
  }
  for (const std::size_t i : v.which.input_loads) {
    add(v.which.loads[i].name, v.flow.loads[i]);
  }
  return names;
}

void emit_absorbing(const PowerView& v, const EachName& each) {
  for (const std::string& name : absorbing_inputs(v)) {
    each(name);
  }
}

bool has_friction(const PowerView& v) {
  return !v.flow.friction.empty();
}

void add_powers(Record<PowerView>& keys) {
  keys.numbers("couplings",
               QuantityKind::power,
               "Power that the tail delivers into the head through each coupling.",
               emit_into_heads)
      .in_tables_as("into_head");
  keys.numbers("supplied",
               QuantityKind::power,
               "Power of each coupling's actions on its own motion: positive where an actuator "
               "drives, negative where it brakes.",
               emit_supplied);
  keys.numbers("actuators",
               QuantityKind::power,
               "Power of each actuator, its action times its rate.",
               emit_actuators)
      .in_tables_as("actuator");
  keys.numbers("loads",
               QuantityKind::power,
               "Power of each load: its wrench on the motion of its body; no key without loads.",
               emit_loads)
      .in_tables_as("load")
      .only_if([](const PowerView& v) { return !v.flow.loads.empty(); });
  keys.numbers("friction",
               QuantityKind::power,
               "Power of the friction of each coupling, never positive; no key without friction.",
               emit_friction)
      .only_if(has_friction);
}

void add_efficiency(Record<PowerView>& keys) {
  keys.part("efficiency",
            efficiency_record(),
            [](const PowerView& v) {
              return EfficiencyView{
                  .flow = v.flow, .meshes = v.efficiency, .preferred = v.mechanism.loss_model};
            })
      .only_if([](const PowerView& v) { return has_friction(v) || v.efficiency != nullptr; });
  keys.flag("self_locking",
            "Friction takes more than the inputs supply, so that the outputs must drive too; no "
            "key without friction.",
            [](const PowerView& v) { return v.flow.is_self_locking; })
      .only_if(has_friction);
  keys.part("losses",
            losses_record(),
            [](const PowerView& v) {
              return LossesView{.topology = v.mechanism.topology,
                                .frictions = v.action.friction,
                                .state = *v.efficiency->state};
            })
      .in_tables_as("")
      .only_if([](const PowerView& v) {
        return v.efficiency != nullptr && v.efficiency->state.has_value();
      });
}

void add_balance(Record<PowerView>& keys) {
  keys.quantity("input",
                QuantityKind::power,
                "Power of the inputs that the case names, else of all actuators and loads that "
                "drive.",
                [](const PowerView& v) { return std::optional(v.flow.input); });
  keys.names("absorbing_inputs",
             "The inputs that the case names and that absorb power, so that it has no efficiency; "
             "no key if none does.",
             emit_absorbing)
      .only_if([](const PowerView& v) { return !absorbing_inputs(v).empty(); });
  keys.number("balance_residual",
              Bare::number,
              "Sum of all supplied powers and those of the loads relative to the largest; zero in "
              "theory. Without unit.",
              [](const PowerView& v) { return std::optional(v.flow.balance_residual); })
      .at_least(0)
      .not_compared();
  static const Record<PowerFlow> evidence(
      "Error bound of the powers.", [](Record<PowerFlow>& of_flow) {
        of_flow
            .number("error_bound",
                    Bare::number,
                    "Largest error of the powers of actuators and the input, relative to the "
                    "largest of all powers; null where rates or actions have no bound.",
                    [](const PowerFlow& flow) { return flow.error_bound; })
            .at_least(0);
      });
  keys.part("evidence", evidence, [](const PowerView& v) -> const PowerFlow& { return v.flow; })
      .not_in_tables()
      .not_compared();
}

}  // namespace

const Record<PowerView>& power_record() {
  static const Record<PowerView> record(
      "Power flow, where both motions and actions are solved.", [](Record<PowerView>& keys) {
        keys.word("status",
                  {std::string(word_of(SolveStatus::solved)),
                   std::string(word_of(SolveStatus::inconsistent))},
                  "Whether the powers sum to zero.",
                  [](const PowerView& v) {
                    return word_of(v.flow.is_balanced ? SolveStatus::solved
                                                      : SolveStatus::inconsistent);
                  })
            .in_tables_is(TableRole::status);
        add_powers(keys);
        add_efficiency(keys);
        add_balance(keys);
        add_power_graph(keys);
      });
  return record;
}

}  // namespace kinestat
