#include "power/power_graph.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/bounded_motion.hpp"
#include "power/circulating_power.hpp"
#include "power/internal/net_power.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

namespace {

class GraphBuilder {
 public:
  GraphBuilder(const Mechanism& mechanism,
               const Case& which,
               const KinematicSolution& motion,
               const StaticSolution& action,
               const PowerFlow& flow)
      : mechanism_(mechanism),
        topology_(mechanism.topology),
        which_(which),
        motion_(motion),
        action_(action),
        flow_(flow) {}

  PowerGraph run() {
    graph_.bodies.assign(topology_.bodies.size(), BodyPower{});
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      add_coupling(CouplingId{e});
    }
    for (std::size_t i = 0; i < flow_.loads.size(); ++i) {
      add_to(which_.loads[i].acts.body, flow_.loads[i]);
    }
    const std::vector<Mesh> meshes = find_meshes(topology_, mechanism_.geometry);
    graph_.meshes = find_mesh_powers(mechanism_, motion_, action_, flow_, meshes);
    graph_.net = find_net_powers(mechanism_, motion_, action_, meshes, graph_.arcs);
    graph_.circulating = find_circulating_power(topology_.body_count(), graph_.net, graph_.meshes);
    graph_.recirculation =
        transmits_only_known() ? find_recirculation(graph_.net, flow_.input) : std::nullopt;
    return std::move(graph_);
  }

 private:
  // The ground, at rest, transmits nothing.
  bool transmits_only_known() const {
    for (std::size_t e = 0; e < topology_.couplings.size(); ++e) {
      const CouplingTopology& coupling = topology_.couplings[e];
      if (!flow_.into_head[e] && coupling.tail.value != 0 && coupling.head.value != 0) {
        return false;
      }
    }
    return true;
  }

  void add_coupling(CouplingId id) {
    const auto e = static_cast<std::size_t>(id.value);
    const CouplingTopology& coupling = topology_.couplings[e];
    if (!flow_.into_head[e]) {
      graph_.bodies[static_cast<std::size_t>(coupling.tail.value)] = std::nullopt;
      graph_.bodies[static_cast<std::size_t>(coupling.head.value)] = std::nullopt;
      return;
    }
    const double into_head = *flow_.into_head[e];
    const double out_of_tail = *flow_.out_of_tail[e];
    add_to(coupling.head, into_head);
    add_to(coupling.tail, -out_of_tail);
    const bool is_forward = into_head > 0.0 && out_of_tail > 0.0;
    const bool is_backward = into_head < 0.0 && out_of_tail < 0.0;
    if (!is_forward && !is_backward) {
      return;
    }
    const bool is_less_at_head = std::abs(into_head) < std::abs(out_of_tail);
    const BoundedNumber through =
        power(*bounded_wrench(action_, id),
              bounded_body(motion_, is_less_at_head ? coupling.head : coupling.tail));
    graph_.arcs.push_back({.coupling = id,
                           .from = is_forward ? coupling.tail : coupling.head,
                           .to = is_forward ? coupling.head : coupling.tail,
                           .power = std::abs(through.value),
                           .bound = through.bound});
  }

  void add_to(BodyId body, double power) {
    std::optional<BodyPower>& powers = graph_.bodies[static_cast<std::size_t>(body.value)];
    if (powers) {
      powers->received += std::max(power, 0.0);
      powers->given += std::max(-power, 0.0);
    }
  }

  const Mechanism& mechanism_;
  const Topology& topology_;
  const Case& which_;
  const KinematicSolution& motion_;
  const StaticSolution& action_;
  const PowerFlow& flow_;
  PowerGraph graph_;
};

}  // namespace

PowerGraph find_power_graph(const Mechanism& mechanism,
                            const Case& which,
                            const KinematicSolution& motion,
                            const StaticSolution& action,
                            const PowerFlow& flow) {
  return GraphBuilder(mechanism, which, motion, action, flow).run();
}

}  // namespace kinestat
