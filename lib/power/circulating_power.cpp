#include "power/circulating_power.hpp"

#include <algorithm>

#include "graph/components.hpp"
#include "power/power_graph.hpp"

namespace kinestat {

namespace {

bool rolls(const std::vector<MeshPower>& meshes, CouplingId coupling) {
  const auto mesh = std::ranges::find(meshes, coupling, &MeshPower::coupling);
  return mesh != meshes.end() && mesh->rolling != 0.0;
}

// As many arcs as bodies are a single circle: each body has one arc that leaves it.
void put_in_order(const std::vector<PowerArc>& net, CirculatingPower& power) {
  const std::vector<std::size_t> arcs = power.arcs;
  BodyId at = power.bodies.front();
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const auto next = *std::ranges::find(arcs, at, [&](std::size_t arc) { return net[arc].from; });
    power.bodies[i] = at;
    power.arcs[i] = next;
    at = net[next].to;
  }
}

CirculatingPower circulating_among(const std::vector<int>& bodies,
                                   const std::vector<PowerArc>& net,
                                   const std::vector<MeshPower>& meshes) {
  CirculatingPower power;
  const auto is_member = [&](BodyId body) { return std::ranges::count(bodies, body.value) > 0; };
  for (const int body : bodies) {
    power.bodies.push_back(BodyId{body});
  }
  for (std::size_t i = 0; i < net.size(); ++i) {
    if (is_member(net[i].from) && is_member(net[i].to)) {
      power.arcs.push_back(i);
      power.largest = std::max(power.largest, net[i].power);
      power.rolls = power.rolls || rolls(meshes, net[i].coupling);
    }
  }
  if (power.arcs.size() == power.bodies.size()) {
    put_in_order(net, power);
  }
  return power;
}

}  // namespace

std::vector<CirculatingPower> find_circulating_power(int body_count,
                                                     const std::vector<PowerArc>& net,
                                                     const std::vector<MeshPower>& meshes) {
  Digraph flow{.vertex_count = body_count, .edges = {}};
  for (const PowerArc& arc : net) {
    flow.edges.push_back({.tail = arc.from.value, .head = arc.to.value});
  }
  std::vector<CirculatingPower> result;
  for (const std::vector<int>& part : find_strong_components(flow)) {
    result.push_back(circulating_among(part, net, meshes));
  }
  return result;
}

std::optional<double> find_recirculation(const std::vector<PowerArc>& net, double input) {
  if (!(input > 0.0)) {
    return std::nullopt;
  }
  double largest = 0.0;
  for (const PowerArc& arc : net) {
    largest = std::max(largest, arc.power);
  }
  return largest / input;
}

}  // namespace kinestat
