#include "power/absolute_efficiency.hpp"

#include <algorithm>

#include "core/tolerance.hpp"
#include "math/elimination.hpp"

namespace kinestat {

namespace {

double kept_by(const Mechanism& mechanism, CouplingId coupling) {
  const auto mesh = std::ranges::find(mechanism.lossy_meshes, coupling, &LossyMesh::coupling);
  return mesh == mechanism.lossy_meshes.end() ? 1.0 : 1.0 - mesh->share;
}

// What bodies get from outside the graph of arcs, and what they give there.
struct Outside {
  std::vector<double> enters;
  std::vector<double> leaves;
};

Outside find_outside(const PowerGraph& graph) {
  Outside outside;
  double largest = 0.0;
  for (const std::optional<BodyPower>& body : graph.bodies) {
    outside.enters.push_back(body->received);
    outside.leaves.push_back(body->given);
    largest = std::max(largest, body->received);
  }
  for (const PowerArc& arc : graph.arcs) {
    outside.enters[static_cast<std::size_t>(arc.to.value)] -= arc.power;
    outside.leaves[static_cast<std::size_t>(arc.from.value)] -= arc.power;
  }
  for (auto* powers : {&outside.enters, &outside.leaves}) {
    for (double& power : *powers) {
      power = power > kPowerBalance * largest ? power : 0.0;
    }
  }
  return outside;
}

}  // namespace

std::optional<double> find_absolute_efficiency(const Mechanism& mechanism,
                                               const PowerGraph& graph) {
  if (!std::ranges::all_of(graph.bodies, &std::optional<BodyPower>::has_value)) {
    return std::nullopt;
  }
  const Outside outside = find_outside(graph);
  const auto given = [&](BodyId body) {
    return graph.bodies[static_cast<std::size_t>(body.value)]->given;
  };
  const int count = mechanism.topology.body_count();
  SparseMatrix system{.rows = count, .columns = count, .entries = {}};
  for (int b = 0; b < count; ++b) {
    system.add(b, b, 1.0);
  }
  for (const PowerArc& arc : graph.arcs) {
    system.add(arc.to.value,
               arc.from.value,
               -kept_by(mechanism, arc.coupling) * arc.power / given(arc.from));
  }
  const VecX received = Elimination(std::move(system), {}).solve({}, outside.enters).x;
  double in = 0.0;
  double out = 0.0;
  for (int b = 0; b < count; ++b) {
    const auto i = static_cast<std::size_t>(b);
    in += outside.enters[i];
    out +=
        outside.leaves[i] == 0.0 ? 0.0 : received[b] * outside.leaves[i] / graph.bodies[i]->given;
  }
  return in > 0.0 ? std::optional(out / in) : std::nullopt;
}

}  // namespace kinestat
