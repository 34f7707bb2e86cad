#include "draw/graph/graph_model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "couplings/kinds.hpp"
#include "draw/picture_title.hpp"
#include "draw/symbols.hpp"
#include "graph/circuit.hpp"
#include "graph/cutsets.hpp"

namespace kinestat {

namespace {

GraphModel bare_model(const Analysis& analysis, std::string name, std::string_view what) {
  const Topology& topology = analysis.mechanism.topology;
  GraphModel model{.name = std::move(name),
                   .title = picture_title(what, analysis),
                   .nodes = {},
                   .edges = {},
                   .power = {},
                   .ports = {}};
  for (const BodyTopology& body : topology.bodies) {
    const auto at = std::ranges::find_if(
        analysis.description.bodies,
        [&](const BodyDescription& written) { return written.name.text == body.name; });
    const bool is_virtual = at != analysis.description.bodies.end() && at->is_virtual;
    model.nodes.push_back(
        {.name = body.name, .is_ground = model.nodes.empty(), .is_virtual = is_virtual});
  }
  for (const CouplingTopology& coupling : topology.couplings) {
    model.edges.push_back({.tail = coupling.tail.value,
                           .head = coupling.head.value,
                           .label = coupling.name,
                           .lines = 1,
                           .stroke = EdgeStroke::chord,
                           .is_mesh = joins_wheels(coupling.type)});
  }
  for (const int branch : analysis.mechanism.graph.tree.branches) {
    model.edges[static_cast<std::size_t>(branch)].stroke = EdgeStroke::branch;
  }
  return model;
}

void put_into_background(GraphModel& model) {
  for (ModelEdge& edge : model.edges) {
    edge.stroke = EdgeStroke::background;
  }
}

// "a - h + c"; the first without a plus.
void add_term(int sign, const std::string& name, std::string& terms) {
  if (terms.empty()) {
    terms = sign < 0 ? "\u2212" + name : name;
  } else {
    terms += fmt::format(" {} {}", sign < 0 ? "\u2212" : "+", name);
  }
}

// What of the power of one case belongs to each edge.
class PowerModeller {
 public:
  PowerModeller(const Analysis& analysis, const CaseAnalysis& one, GraphModel& model)
      : topology_(analysis.mechanism.topology),
        units_(analysis.description.units),
        one_(one),
        model_(model) {}

  void add() {
    model_.power.resize(model_.edges.size());
    const PowerFlow& flow = *one_.power;
    for (std::size_t e = 0; e < model_.edges.size(); ++e) {
      if (flow.into_head[e]) {
        add_edge(e, *flow.into_head[e], *flow.out_of_tail[e]);
      }
    }
    mark_circles();
    add_loads();
  }

 private:
  std::string in_unit(double power) const {
    return fmt::format("{} {}",
                       short_number(units_.from_si(QuantityKind::power, power)),
                       units_.text(QuantityKind::power));
  }

  // `into_head` reaches the head, `out_of_tail` leaves the tail; the ground, which rests, has none.
  void add_edge(std::size_t e, double into_head, double out_of_tail) {
    const bool is_at_ground = model_.edges[e].tail == 0 || model_.edges[e].head == 0;
    const double along = model_.edges[e].tail == 0   ? into_head
                         : model_.edges[e].head == 0 ? out_of_tail
                                                     : smaller(into_head, out_of_tail);
    if (!is_at_ground && drives(e)) {
      add_drive(e, into_head - along, model_.edges[e].head);
      add_drive(e, along - out_of_tail, model_.edges[e].tail);
    }
    const double lost = lost_in(e);
    if (along == 0.0) {
      if (lost > 0.0 && !drives(e)) {
        add_loss(e, std::max(out_of_tail, 0.0), model_.edges[e].tail);
        add_loss(e, std::max(-into_head, 0.0), model_.edges[e].head);
      }
      return;
    }
    ModelPower& power = model_.power[e];
    power.size = std::abs(along);
    power.is_forward = along > 0.0;
    power.text = in_unit(power.size);
    if (is_at_ground) {
      power.text += role_of(e, lost > 0.0);
    }
    if (lost > 0.0 && (is_at_ground || !drives(e))) {
      power.text += fmt::format(", {} lost", in_unit(lost));
    }
  }

  // In a coupling, to friction and slip.
  double lost_in(std::size_t e) const {
    if (!drives(e)) {
      return -one_.power->supplied[e];
    }
    double lost = 0.0;
    for (std::size_t i = 0; i < one_.action->friction.size(); ++i) {
      const bool is_here = one_.action->friction[i].coupling.value == static_cast<int>(e);
      lost -= is_here ? one_.power->friction[i] : 0.0;
    }
    return lost;
  }

  void add_loss(std::size_t e, double power, int body) {
    if (power > 0.0) {
      add_port(body, -power, fmt::format("lost in {}", topology_.couplings[e].name));
    }
  }

  static double smaller(double a, double b) {
    if (a * b <= 0.0) {
      return 0.0;
    }
    return std::abs(a) < std::abs(b) ? a : b;
  }

  // What an actuator between two moving bodies gives or takes besides what passes through it.
  void add_drive(std::size_t e, double power, int body) {
    if (power != 0.0) {
      add_port(body, power, role_of(e).substr(2));
    }
  }

  void add_port(int body, double power, const std::string& name) {
    model_.ports.push_back({.node = body,
                            .enters = power > 0.0,
                            .size = std::abs(power),
                            .text = fmt::format("{} {}", name, in_unit(std::abs(power)))});
  }

  bool drives(std::size_t e) const { return !role_of(e).empty(); }

  // ", input C1", by the actuators of the coupling, with their powers where friction takes a part.
  std::string role_of(std::size_t e, bool with_power = false) const {
    std::string text;
    for (std::size_t i = 0; i < topology_.actuators.size(); ++i) {
      const ActuatorTopology& actuator = topology_.actuators[i];
      const auto f = static_cast<std::size_t>(actuator.freedom);
      if (topology_.freedoms[f].coupling.value != static_cast<int>(e) ||
          one_.power->actuators[i] == 0.0) {
        continue;
      }
      const auto holds = [&](const std::vector<int>& list) {
        return std::ranges::find(list, static_cast<int>(i)) != list.end();
      };
      text += holds(one_.which.inputs)    ? ", input "
              : holds(one_.which.outputs) ? ", output "
                                          : ", ";
      text += actuator.name;
      text += with_power ? " " + in_unit(std::abs(one_.power->actuators[i])) : "";
    }
    return text;
  }

  void mark_circles() {
    if (!one_.power_graph) {
      return;
    }
    for (const CirculatingPower& loop : one_.power_graph->circulating) {
      for (const std::size_t arc : loop.arcs) {
        const CouplingId coupling = one_.power_graph->net[arc].coupling;
        model_.power[static_cast<std::size_t>(coupling.value)].recirculates = true;
      }
    }
  }

  void add_loads() {
    for (std::size_t i = 0; i < one_.which.loads.size(); ++i) {
      const double power = one_.power->loads[i];
      if (power != 0.0) {
        add_port(one_.which.loads[i].acts.body.value, power, one_.which.loads[i].name);
      }
    }
  }

  const Topology& topology_;
  const FileUnits& units_;
  const CaseAnalysis& one_;
  GraphModel& model_;
};

// A line for each of the freedoms or actions of a coupling, which its label names.
template <class Label>
void multiply_edge(const std::vector<Label>& labels, int first, int count, ModelEdge& edge) {
  edge.lines = count;
  edge.label += ":";
  for (int i = first; i < first + count; ++i) {
    edge.label += " " + labels[static_cast<std::size_t>(i)].name;
  }
}

}  // namespace

GraphModel coupling_graph_model(const Analysis& analysis) {
  return bare_model(analysis, "coupling_graph", "Coupling graph");
}

GraphModel motion_graph_model(const Analysis& analysis) {
  GraphModel model = bare_model(analysis, "motion_graph", "Motion graph");
  const Topology& topology = analysis.mechanism.topology;
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    const CouplingTopology& coupling = topology.couplings[e];
    multiply_edge(
        topology.freedoms, coupling.first_freedom, coupling.freedom_count, model.edges[e]);
  }
  return model;
}

GraphModel action_graph_model(const Analysis& analysis) {
  GraphModel model = bare_model(analysis, "action_graph", "Action graph");
  const Topology& topology = analysis.mechanism.topology;
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    const CouplingTopology& coupling = topology.couplings[e];
    multiply_edge(topology.actions, coupling.first_action, coupling.action_count, model.edges[e]);
  }
  return model;
}

std::vector<GraphModel> circuit_models(const Analysis& analysis) {
  std::vector<GraphModel> models;
  for (const Circuit& circuit : find_circuits(analysis.mechanism.graph)) {
    GraphModel model = bare_model(analysis, "circuits", "");
    put_into_background(model);
    std::string terms;
    for (const CircuitEdge& edge : circuit.edges) {
      ModelEdge& shown = model.edges[static_cast<std::size_t>(edge.coupling.value)];
      shown.stroke = EdgeStroke::highlight;
      add_term(edge.sign, shown.label, terms);
    }
    model.title = fmt::format(
        "Circuit {}: {}", analysis.mechanism.topology.coupling(circuit.chord).name, terms);
    models.push_back(std::move(model));
  }
  return models;
}

std::vector<GraphModel> cutset_models(const Analysis& analysis) {
  const CouplingGraph& graph = analysis.mechanism.graph;
  const MatXi cutsets = cutset_matrix(graph);
  std::vector<GraphModel> models;
  for (int row = 0; row < cutsets.rows(); ++row) {
    GraphModel model = bare_model(analysis, "cutsets", "");
    put_into_background(model);
    std::string terms;
    for (int column = 0; column < cutsets.cols(); ++column) {
      const int edge = graph.columns[static_cast<std::size_t>(column)];
      if (cutsets(row, column) != 0) {
        ModelEdge& shown = model.edges[static_cast<std::size_t>(edge)];
        shown.stroke = EdgeStroke::highlight;
        add_term(cutsets(row, column), shown.label, terms);
      }
    }
    const int branch = graph.columns[static_cast<std::size_t>(row)];
    model.title = fmt::format(
        "Cut-set {}: {}", analysis.mechanism.topology.coupling(CouplingId{branch}).name, terms);
    models.push_back(std::move(model));
  }
  return models;
}

GraphModel power_model(const Analysis& analysis, std::size_t which) {
  KINESTAT_EXPECTS(which < analysis.cases.size() && analysis.cases[which].power.has_value());
  const CaseAnalysis& one = analysis.cases[which];
  GraphModel model = bare_model(analysis, "power_flow", "");
  model.title = picture_title_of_case(
      one.efficiency ? "Power flow without mesh losses" : "Power flow", one, analysis);
  PowerModeller(analysis, one, model).add();
  return model;
}

}  // namespace kinestat
