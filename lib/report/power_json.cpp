#include "report/power_json.hpp"

#include <utility>

#include "report/efficiency_json.hpp"

namespace kinestat {

namespace {

// By coupling: each hands power on one way.
Json arcs_json(const Topology& topology, const PowerGraph& graph, const InUnits& in) {
  Json arcs = object_of(graph.arcs.size());
  for (const PowerArc& one : graph.arcs) {
    Json& arc = appended(arcs, topology.coupling(one.coupling).name);
    arc["from"] = topology.body(one.from).name;
    arc["to"] = topology.body(one.to).name;
    arc["power"] = number(in.power(one.power));
  }
  return arcs;
}

// The ground is at rest, so that nothing goes through it.
Json bodies_json(const Topology& topology, const PowerGraph& graph, const InUnits& in) {
  Json bodies = object_of(graph.bodies.size());
  for (std::size_t b = 1; b < graph.bodies.size(); ++b) {
    const std::optional<BodyPower>& powers = graph.bodies[b];
    Json& body = appended(bodies, topology.bodies[b].name);
    body["received"] = powers ? number(in.power(powers->received)) : Json(nullptr);
    body["given"] = powers ? number(in.power(powers->given)) : Json(nullptr);
  }
  return bodies;
}

Json meshes_json(const Topology& topology, const PowerGraph& graph, const InUnits& in) {
  Json meshes = object_of(graph.meshes.size());
  for (const MeshPower& one : graph.meshes) {
    Json& mesh = appended(meshes, topology.coupling(one.coupling).name);
    mesh["carrier"] = topology.body(one.carrier).name;
    mesh["rolling"] = number(in.power(one.rolling));
  }
  return meshes;
}

Json loop_json(const Topology& topology,
               const PowerGraph& graph,
               const PowerLoop& loop,
               const InUnits& in) {
  Json result = object_of(4);
  result["bodies"] = Json::array();
  for (const BodyId body : loop.bodies) {
    result["bodies"].push_back(topology.body(body).name);
  }
  result["couplings"] = Json::array();
  result["powers"] = Json::array();
  for (const std::size_t arc : loop.arcs) {
    result["couplings"].push_back(topology.coupling(graph.net[arc].coupling).name);
    result["powers"].push_back(number(in.power(graph.net[arc].power)));
  }
  result["rolls"] = loop.rolls;
  return result;
}

void add_graph(const Topology& topology, const PowerGraph& graph, const InUnits& in, Json& result) {
  result["arcs"] = arcs_json(topology, graph, in);
  result["bodies"] = bodies_json(topology, graph, in);
  if (!graph.meshes.empty()) {
    result["meshes"] = meshes_json(topology, graph, in);
  }
  Json& recirculation = result["recirculation"];
  recirculation["factor"] = number(graph.factor);
  recirculation["loops"] = Json::array();
  for (const PowerLoop& loop : graph.loops) {
    recirculation["loops"].push_back(loop_json(topology, graph, loop, in));
  }
}

}  // namespace

Json power_json(const Mechanism& mechanism, const CaseAnalysis& one, const InUnits& in) {
  const Topology& topology = mechanism.topology;
  const PowerFlow& flow = *one.power;
  Json result = object_of(8);
  result["status"] = flow.is_balanced ? "solved" : "inconsistent";
  Json couplings = object_of(topology.couplings.size());
  Json supplied = object_of(topology.couplings.size());
  for (std::size_t e = 0; e < topology.couplings.size(); ++e) {
    appended(couplings, topology.couplings[e].name) =
        flow.into_head[e] ? number(in.power(*flow.into_head[e])) : Json(nullptr);
    appended(supplied, topology.couplings[e].name) = number(in.power(flow.supplied[e]));
  }
  result["couplings"] = std::move(couplings);
  result["supplied"] = std::move(supplied);
  result["actuators"] = object_of(8);
  for (std::size_t i = 0; i < topology.actuators.size(); ++i) {
    result["actuators"][topology.actuators[i].name] = number(in.power(flow.actuators[i]));
  }
  if (!flow.loads.empty()) {
    result["loads"] = object_of(flow.loads.size());
    for (std::size_t i = 0; i < flow.loads.size(); ++i) {
      result["loads"][one.which.loads[i].name] = number(in.power(flow.loads[i]));
    }
  }
  if (!flow.friction.empty()) {
    result["friction"] = object_of(flow.friction.size());
    for (std::size_t i = 0; i < flow.friction.size(); ++i) {
      const CouplingId coupling = one.action->friction[i].coupling;
      result["friction"][topology.coupling(coupling).name] = number(in.power(flow.friction[i]));
    }
    result["efficiency"]["friction"] = number(flow.efficiency);
    if (!flow.no_efficiency.empty()) {
      result["efficiency"]["reason"] = flow.no_efficiency;
    }
    result["self_locking"] = flow.is_self_locking;
  }
  if (one.efficiency) {
    add_efficiency(mechanism, one, in, result);
  }
  result["input"] = number(in.power(flow.input));
  result["balance_residual"] = number(flow.balance_residual);
  result["evidence"]["error_bound"] = number(flow.error_bound);
  add_graph(topology, *one.power_graph, in, result);
  return result;
}

}  // namespace kinestat
