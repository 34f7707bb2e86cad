#include "power/absolute_efficiency.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/tolerance.hpp"
#include "math/elimination/elimination.hpp"

namespace kinestat {

namespace {

double kept_by(const Mechanism& mechanism, CouplingId coupling) {
  const auto mesh = std::ranges::find(mechanism.lossy_meshes, coupling, &LossyMesh::coupling);
  return mesh == mechanism.lossy_meshes.end() ? 1.0 : 1.0 - mesh->share;
}

// What enters and leaves the bodies of one coupling beside what it transmits from one to the other.
// A coupling that supplies power lets none leave, and one that takes it none enter.
struct Exchange {
  double into_tail = 0.0;  ///< negative: out of it
  double into_head = 0.0;
};

Exchange exchange_of(double into_head, double supplied) {
  const double out_of_tail = into_head - supplied;
  if ((into_head > 0.0) != (out_of_tail > 0.0)) {
    return {.into_tail = -out_of_tail, .into_head = into_head};
  }
  // Transmitted is the lesser of the two; the rest enters or leaves at the side of the greater.
  const bool is_forward = into_head > 0.0;
  const bool gives = supplied > 0.0;
  return is_forward == gives ? Exchange{.into_tail = 0.0, .into_head = supplied}
                             : Exchange{.into_tail = supplied, .into_head = 0.0};
}

// The powers between the network and its outside, body by body.
struct Outside {
  std::vector<double> enters;
  std::vector<double> leaves;   ///< by the outputs alone
  std::vector<double> through;  ///< what one actuator of a coupling gives another, within the body
};

// Powers of the actuators on one coupling, none of them negative.
struct ActuatorPowers {
  double given = 0.0;
  double taken = 0.0;
  double to_outputs = 0.0;  ///< of `taken`
};

class OutsideFinder {
 public:
  OutsideFinder(const Mechanism& mechanism, const Case& which, const PowerFlow& flow)
      : topology_(mechanism.topology), which_(which), flow_(flow) {}

  Outside run() {
    for (auto* const list : {&result_.enters, &result_.leaves, &result_.through}) {
      list->assign(topology_.bodies.size(), 0.0);
    }
    for (int e = 0; e < topology_.coupling_count(); ++e) {
      add(CouplingId{e});
    }
    return std::move(result_);
  }

 private:
  void add(CouplingId id) {
    const auto e = static_cast<std::size_t>(id.value);
    if (!flow_.into_head[e]) {
      return;
    }
    const ActuatorPowers powers = powers_on(id);
    const double through = std::min(powers.given, powers.taken);
    const double useful = powers.taken == 0.0 ? 0.0 : powers.to_outputs / powers.taken;
    if (through > 0.0) {
      const CouplingTopology& coupling = topology_.couplings[e];
      const BodyId body = coupling.head.value != 0 ? coupling.head : coupling.tail;
      const auto b = static_cast<std::size_t>(body.value);
      result_.enters[b] += through;
      result_.leaves[b] += useful * through;
      result_.through[b] += through;
    }
    const double supplied = flow_.supplied[e];
    if (supplied == 0.0) {
      return;
    }
    // Friction in the coupling may take the rest.
    const double leaves = useful * (powers.taken - through) / std::abs(supplied);
    const Exchange exchange = exchange_of(*flow_.into_head[e], supplied);
    add(topology_.couplings[e].tail, exchange.into_tail, leaves);
    add(topology_.couplings[e].head, exchange.into_head, leaves);
  }

  void add(BodyId body, double into, double useful) {
    const auto b = static_cast<std::size_t>(body.value);
    (into > 0.0 ? result_.enters[b] : result_.leaves[b]) += into > 0.0 ? into : useful * -into;
  }

  ActuatorPowers powers_on(CouplingId coupling) const {
    ActuatorPowers powers;
    for (std::size_t i = 0; i < topology_.actuators.size(); ++i) {
      const auto freedom = static_cast<std::size_t>(topology_.actuators[i].freedom);
      if (topology_.freedoms[freedom].coupling != coupling) {
        continue;
      }
      const double power = flow_.actuators[i];
      const bool is_output =
          std::ranges::find(which_.outputs, static_cast<int>(i)) != which_.outputs.end();
      powers.given += std::max(power, 0.0);
      powers.taken += std::max(-power, 0.0);
      powers.to_outputs += is_output ? std::max(-power, 0.0) : 0.0;
    }
    return powers;
  }

  const Topology& topology_;
  const Case& which_;
  const PowerFlow& flow_;
  Outside result_;
};

}  // namespace

std::optional<double> find_absolute_efficiency(const Mechanism& mechanism,
                                               const Case& which,
                                               const PowerFlow& flow,
                                               const PowerGraph& graph) {
  if (!std::ranges::all_of(graph.bodies, &std::optional<BodyPower>::has_value)) {
    return std::nullopt;
  }
  const Outside outside = OutsideFinder(mechanism, which, flow).run();
  const auto given = [&](BodyId body) {
    const auto b = static_cast<std::size_t>(body.value);
    return graph.bodies[b]->given + outside.through[b];
  };
  const int count = mechanism.topology.body_count();
  SparseMatrix system{.rows = count, .columns = count, .entries = {}};
  for (int b = 0; b < count; ++b) {
    system.add(b, b, 1.0);
  }
  for (const PowerArc& arc : graph.arcs) {
    system.add(arc.to.value,
               arc.from.value,
               -kept_by(mechanism, arc.coupling) * (arc.power / given(arc.from)));
  }
  const Elimination elimination(std::move(system), {});
  if (elimination.rank() < count) {
    return std::nullopt;
  }
  const VecX received = elimination.solve({}, outside.enters).x;
  double in = 0.0;
  for (const int input : which.inputs) {
    in += flow.actuators[static_cast<std::size_t>(input)];
  }
  double out = 0.0;
  for (int b = 1; b < count; ++b) {  // the ground, at rest, takes nothing
    const double leaves = outside.leaves[static_cast<std::size_t>(b)];
    out += leaves > 0.0 ? received[b] * (leaves / given(BodyId{b})) : 0.0;
  }
  return out / in;
}

}  // namespace kinestat
