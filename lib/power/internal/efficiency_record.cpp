#include "power/internal/efficiency_record.hpp"

#include "mechanism/label_kind.hpp"

namespace kinestat {

namespace {

// An efficiency with losses of meshes.
struct Share {
  const char* key;
  const Efficiency TransmissionEfficiency::*of;
  const char* meaning;
};

constexpr Share kShares[] = {
    {"carrier",
     &TransmissionEfficiency::carrier,
     "A mesh loses a fraction of the rolling power relative to its carrier: none in a train that "
     "turns as a block. Includes friction of couplings."},
    {"carrier_backward",
     &TransmissionEfficiency::carrier_backward,
     "The same with all motion reversed under the same known actions and loads, so that the "
     "outputs drive."},
    {"absolute",
     &TransmissionEfficiency::absolute,
     "A mesh loses a fraction of the power through it relative to the ground, including power that "
     "is only carried around with its gears. Includes friction of couplings."}};

bool has_meshes(const EfficiencyView& v) {
  return v.meshes != nullptr;
}

bool locks_one(const EfficiencyView& v) {
  return has_meshes(v) && std::ranges::any_of(kShares, [&](const Share& share) {
           return (v.meshes->*share.of).is_self_locking;
         });
}

bool lacks_one(const EfficiencyView& v) {
  return has_meshes(v) && std::ranges::any_of(kShares, [&](const Share& share) {
           return !(v.meshes->*share.of).reason.empty();
         });
}

const Record<TransmissionEfficiency>& reasons_record() {
  using View = TransmissionEfficiency;
  static const Record<View> record(
      "Why those of the meshes are null or 0, by name; no key if none is.", [](Record<View>& keys) {
        for (const Share& share : kShares) {
          keys.text(share.key,
                    std::string("Why there is no efficiency ") + share.key + ".",
                    [&share](const View& v) { return (v.*share.of).reason; })
              .only_if([&share](const View& v) { return !(v.*share.of).reason.empty(); });
        }
      });
  return record;
}

void emit_locking(const EfficiencyView& v, const EachName& each) {
  for (const Share& share : kShares) {
    if ((v.meshes->*share.of).is_self_locking) {
      each(share.key);
    }
  }
}

struct LossyMeshView {
  const Topology& topology;
  const MeshLossPower& loss;
};

const Record<LossyMeshView>& lossy_mesh_record() {
  static const Record<LossyMeshView> record("One mesh.", [](Record<LossyMeshView>& keys) {
    keys.flag("rolls",
              "Whether its gears turn relative to its carrier; otherwise it loses nothing.",
              [](const LossyMeshView& v) { return v.loss.rolls; });
    keys.text("driven",
              "The gear that the loss holds back; no key where nothing is lost.",
              [](const LossyMeshView& v) { return v.topology.body(*v.loss.driven).name; })
        .only_if([](const LossyMeshView& v) { return v.loss.driven.has_value(); });
    keys.quantity("couple",
                  QuantityKind::moment,
                  "Between it and the carrier.",
                  [](const LossyMeshView& v) { return v.loss.couple; })
        .at_least(0);
    keys.quantity("power", QuantityKind::power, "Of that couple.", [](const LossyMeshView& v) {
      return v.loss.power;
    });
  });
  return record;
}

void emit_lossy_meshes(const LossesView& v, const Each<LossyMeshView>& each) {
  for (const MeshLossPower& one : v.state.meshes) {
    each(v.topology.coupling(one.mesh).name, {.topology = v.topology, .loss = one});
  }
}

void emit_lossy_friction(const LossesView& v, const EachNumber& each) {
  for (std::size_t i = 0; i < v.state.friction.size(); ++i) {
    each(v.topology.coupling(v.frictions[i].coupling).name,
         v.state.friction[i],
         QuantityKind::power);
  }
}

void emit_lossy_actuators(const LossesView& v, const EachNumber& each) {
  for (const ActuatorTopology& actuator : v.topology.actuators) {
    const auto a = static_cast<std::size_t>(actuator.action);
    each(actuator.name, v.state.actions[a], kind_of(v.topology.actions[a]));
  }
}

void emit_lossy_powers(const LossesView& v, const EachNumber& each) {
  for (std::size_t i = 0; i < v.topology.actuators.size(); ++i) {
    each(v.topology.actuators[i].name, v.state.actuators[i], QuantityKind::power);
  }
}

}  // namespace

const Record<EfficiencyView>& efficiency_record() {
  using View = EfficiencyView;
  static const Record<View> record(
      "Power of the outputs over that of the inputs, by model of loss; no key without friction or "
      "losses of meshes.",
      [](Record<View>& keys) {
        const auto has_friction = [](const View& v) { return !v.flow.friction.empty(); };
        keys.number("friction",
                    Bare::efficiency,
                    "With the friction of couplings alone; null unless the case names inputs that "
                    "give power and outputs that take it, and nothing else exchanges any. No key "
                    "without friction.",
                    [](const View& v) { return v.flow.efficiency; })
            .only_if(has_friction);
        keys.text("reason",
                  "Why that of friction is null or 0 although the case names inputs and outputs.",
                  [](const View& v) { return v.flow.no_efficiency; })
            .not_compared()
            .only_if([has_friction](const View& v) {
              return has_friction(v) && !v.flow.no_efficiency.empty();
            });
        keys.word("model",
                  {"carrier", "absolute"},
                  "The model that the file prefers; both are reported. No key without losses of "
                  "meshes, as of all that follow.",
                  [](const View& v) {
                    return v.preferred == LossModel::carrier ? "carrier" : "absolute";
                  })
            .only_if(has_meshes);
        for (const Share& share : kShares) {
          keys.number(share.key,
                      Bare::efficiency,
                      share.meaning,
                      [&share](const View& v) { return (v.meshes->*share.of).value; })
              .at_least(0)
              .only_if(has_meshes);
        }
        keys.part("reasons",
                  reasons_record(),
                  [](const View& v) -> const TransmissionEfficiency& { return *v.meshes; })
            .not_in_tables()
            .not_compared()
            .only_if(lacks_one);
        keys.names("self_locking",
                   "Those of them in whose direction the outputs cannot be driven by the inputs "
                   "alone; no key if all can.",
                   emit_locking)
            .only_if(locks_one);
      });
  return record;
}

const Record<LossesView>& losses_record() {
  static const Record<LossesView> record(
      "What is lost in the carrier model, and what acts then; no key without losses of meshes, nor "
      "where they lock or are open.",
      [](Record<LossesView>& keys) {
        keys.map(
                "meshes", lossy_mesh_record(), "The meshes that may lose power.", emit_lossy_meshes)
            .in_tables_as("loss");
        keys.numbers("friction",
                     QuantityKind::power,
                     "Power of the friction of each coupling in presence of the losses of meshes, "
                     "never positive; no key without friction.",
                     emit_lossy_friction)
            .in_tables_as("lossy_friction")
            .only_if([](const LossesView& v) { return !v.state.friction.empty(); });
        keys.numbers("actuators",
                     ByContext::action,
                     "Action of each actuator with all losses, of tail on head, in the unit of "
                     "moment or force; null where equilibrium leaves it undetermined.",
                     emit_lossy_actuators)
            .in_tables_as("lossy_action");
        keys.numbers("powers",
                     QuantityKind::power,
                     "Power that each actuator supplies with all losses.",
                     emit_lossy_powers)
            .in_tables_as("lossy_power");
        keys.quantity(
                "input",
                QuantityKind::power,
                "Power of the inputs with all losses; without inputs that of all actuators and "
                "loads that supply power.",
                [](const LossesView& v) { return v.state.input; })
            .in_tables_as("losses/input");
        keys.number("balance_residual",
                    Bare::number,
                    "Sum of the powers of actuators, loads and losses relative to the largest; "
                    "zero in theory. Without unit.",
                    [](const LossesView& v) { return v.state.balance_residual; })
            .at_least(0)
            .in_tables_as("losses/balance_residual")
            .not_compared();
      });
  return record;
}

}  // namespace kinestat
