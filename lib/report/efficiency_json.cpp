#include "report/efficiency_json.hpp"

namespace kinestat {

namespace {

// Beside that of friction.
void add_shares(const TransmissionEfficiency& efficiency, LossModel model, Json& shares) {
  shares["model"] = model == LossModel::carrier ? "carrier" : "absolute";
  Json reasons = object_of(3);
  Json locking = Json::array();
  const auto add = [&](const char* name, const Efficiency& one) {
    shares[name] = number(one.value);
    if (!one.reason.empty()) {
      reasons[name] = one.reason;
    }
    if (one.is_self_locking) {
      locking.push_back(name);
    }
  };
  add("carrier", efficiency.carrier);
  add("carrier_backward", efficiency.carrier_backward);
  add("absolute", efficiency.absolute);
  if (!reasons.empty()) {
    shares["reasons"] = std::move(reasons);
  }
  if (!locking.empty()) {
    shares["self_locking"] = std::move(locking);
  }
}

Json meshes_json(const Topology& topology, const LossyState& state, const InUnits& in) {
  Json meshes = object_of(state.meshes.size());
  for (const MeshLossPower& one : state.meshes) {
    Json& mesh = meshes[topology.coupling(one.mesh).name];
    mesh["rolls"] = one.rolls;
    if (one.driven) {
      mesh["driven"] = topology.body(*one.driven).name;
    }
    mesh["couple"] = number(in.action(one.couple, true));
    mesh["power"] = number(in.power(one.power));
  }
  return meshes;
}

Json losses_json(const Topology& topology,
                 const std::vector<FrictionAction>& frictions,
                 const LossyState& state,
                 const InUnits& in) {
  Json losses = object_of(4);
  losses["meshes"] = meshes_json(topology, state, in);
  if (!state.friction.empty()) {
    losses["friction"] = object_of(state.friction.size());
  }
  for (std::size_t i = 0; i < state.friction.size(); ++i) {
    losses["friction"][topology.coupling(frictions[i].coupling).name] =
        number(in.power(state.friction[i]));
  }
  losses["actuators"] = object_of(topology.actuators.size());
  for (const ActuatorTopology& actuator : topology.actuators) {
    const auto a = static_cast<std::size_t>(actuator.action);
    losses["actuators"][actuator.name] =
        state.actions[a] ? number(in.action(*state.actions[a], topology.actions[a].is_couple))
                         : Json(nullptr);
  }
  losses["balance_residual"] = number(state.balance_residual);
  return losses;
}

}  // namespace

void add_efficiency(const Mechanism& mechanism,
                    const CaseAnalysis& one,
                    const InUnits& in,
                    Json& power) {
  add_shares(*one.efficiency, mechanism.loss_model, power["efficiency"]);
  if (one.efficiency->state) {
    power["losses"] =
        losses_json(mechanism.topology, one.action->friction, *one.efficiency->state, in);
  }
}

}  // namespace kinestat
