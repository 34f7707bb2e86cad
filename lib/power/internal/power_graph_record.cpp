#include "power/internal/power_graph_record.hpp"

namespace kinestat {

namespace {

struct ArcView {
  const Topology& topology;
  const PowerArc& arc;
};

const Record<ArcView>& arc_record() {
  static const Record<ArcView> record("One coupling.", [](Record<ArcView>& keys) {
    keys.text("from", "Body that gives the power.", [](const ArcView& v) {
      return v.topology.body(v.arc.from).name;
    });
    keys.text("to", "Body that receives it.", [](const ArcView& v) {
      return v.topology.body(v.arc.to).name;
    });
    keys.quantity("power",
                  QuantityKind::power,
                  "The power that leaves one and reaches the other, the smaller of the two.",
                  [](const ArcView& v) { return v.arc.power; })
        .at_least(0);
  });
  return record;
}

const Record<std::optional<BodyPower>>& body_power_record() {
  using View = std::optional<BodyPower>;
  static const Record<View> record("One body.", [](Record<View>& keys) {
    keys.quantity("received",
                  QuantityKind::power,
                  "Sum of what comes in.",
                  [](const View& v) { return v ? std::optional(v->received) : std::nullopt; })
        .at_least(0);
    keys.quantity("given",
                  QuantityKind::power,
                  "Sum of what goes out.",
                  [](const View& v) { return v ? std::optional(v->given) : std::nullopt; })
        .at_least(0);
  });
  return record;
}

struct MeshView {
  const Topology& topology;
  const MeshPower& mesh;
};

const Record<MeshView>& mesh_record() {
  static const Record<MeshView> record("One mesh.", [](Record<MeshView>& keys) {
    keys.text("carrier",
              "Name of the carrier; the ground where the axes are fixed.",
              [](const MeshView& v) { return v.topology.body(v.mesh.carrier).name; });
    keys.quantity("rolling",
                  QuantityKind::power,
                  "Power into the head in the frame of the carrier: mesh losses are a fraction of "
                  "its magnitude.",
                  [](const MeshView& v) { return v.mesh.rolling; });
  });
  return record;
}

struct LoopView {
  const Topology& topology;
  const PowerGraph& graph;
  const CirculatingPower& loop;
};

const Record<LoopView>& loop_record() {
  static const Record<LoopView> record(
      "One circle, or several that share bodies.", [](Record<LoopView>& keys) {
        keys.names("bodies",
                   "Its bodies, in the direction of the flow if it is a single circle.",
                   [](const LoopView& v, const EachName& each) {
                     for (const BodyId body : v.loop.bodies) {
                       each(v.topology.body(body).name);
                     }
                   });
        keys.names("couplings",
                   "The couplings through which the power flows, likewise.",
                   [](const LoopView& v, const EachName& each) {
                     for (const std::size_t arc : v.loop.arcs) {
                       each(v.topology.coupling(v.graph.net[arc].coupling).name);
                     }
                   });
        keys.custom("powers",
                    list_shape(number_shape(QuantityKind::power, false)),
                    "What goes through each of them; of the bearings of planets that mesh with "
                    "each other, the strongest stands for the sum.",
                    [](const LoopView& v, Archive& to) {
                      to.begin_list();
                      for (const std::size_t arc : v.loop.arcs) {
                        to.quantity(v.graph.net[arc].power, QuantityKind::power);
                      }
                      to.end_list();
                    });
        keys.flag("rolls",
                  "Whether a mesh among them rolls in its carrier; a train that turns as a block "
                  "loses nothing.",
                  [](const LoopView& v) { return v.loop.rolls; });
      });
  return record;
}

// In tables the power of an arc stands beside its coupling and the bodies that it joins.
void write_arc_rows(const PowerView& v, Archive& to) {
  const Topology& topology = v.mechanism.topology;
  to.begin_map();
  for (const PowerArc& arc : v.graph.arcs) {
    Property bodies;
    bodies.table_quantity = topology.body(arc.from).name + "/" + topology.body(arc.to).name;
    to.element(topology.coupling(arc.coupling).name, {});
    to.begin(bodies);
    to.quantity(arc.power, QuantityKind::power);
    to.end(bodies);
  }
  to.end_map();
}

// That of a coupling with circulating power beside the number of the circle.
void write_loop_rows(const PowerView& v, Archive& to) {
  to.begin_list();
  for (const CirculatingPower& loop : v.graph.circulating) {
    to.begin_map();
    for (const std::size_t arc : loop.arcs) {
      to.element(v.mechanism.topology.coupling(v.graph.net[arc].coupling).name, {});
      to.quantity(v.graph.net[arc].power, QuantityKind::power);
    }
    to.end_map();
  }
  to.end_list();
}

const Record<PowerView>& recirculation_record() {
  static const Record<PowerView> record(
      "Power that circulates and loads its members without reaching the output.",
      [](Record<PowerView>& keys) {
        keys.number("factor",
                    Bare::number,
                    "Largest power from shaft to shaft over the input power, planets that mesh "
                    "with each other being one; null without input, or where equilibrium leaves "
                    "powers between bodies open.",
                    [](const PowerView& v) { return v.graph.recirculation; })
            .at_least(0);
        keys.list("loops",
                  loop_record(),
                  "Bodies each of which sends power, by way of others, to all the others; only by "
                  "powers that equilibrium determines.",
                  [](const PowerView& v, const Each<LoopView>& each) {
                    for (const CirculatingPower& loop : v.graph.circulating) {
                      each({.topology = v.mechanism.topology, .graph = v.graph, .loop = loop});
                    }
                  })
            .not_in_tables();
      });
  return record;
}

void emit_arcs(const PowerView& v, const Each<ArcView>& each) {
  for (const PowerArc& arc : v.graph.arcs) {
    each(v.mechanism.topology.coupling(arc.coupling).name,
         {.topology = v.mechanism.topology, .arc = arc});
  }
}

// The ground is at rest, so that nothing goes through it.
void emit_body_powers(const PowerView& v, const Each<std::optional<BodyPower>>& each) {
  for (std::size_t b = 1; b < v.graph.bodies.size(); ++b) {
    each(v.mechanism.topology.bodies[b].name, v.graph.bodies[b]);
  }
}

void emit_meshes(const PowerView& v, const Each<MeshView>& each) {
  for (const MeshPower& mesh : v.graph.meshes) {
    each(v.mechanism.topology.coupling(mesh.coupling).name,
         {.topology = v.mechanism.topology, .mesh = mesh});
  }
}

const Shape& row_shape() {
  static const Shape shape = map_shape(number_shape(QuantityKind::power, false));
  return shape;
}

}  // namespace

void add_power_graph(Record<PowerView>& keys) {
  keys.map("arcs",
           arc_record(),
           "Direction of the power flow through each coupling that transmits power from one body "
           "to another, relative to the ground.",
           emit_arcs)
      .not_in_tables();
  keys.map("bodies",
           body_power_record(),
           "Power that each moving body receives and delivers through its couplings and loads: "
           "equal if balanced; null where one of its actions is undetermined.",
           emit_body_powers)
      .in_tables_as("body");
  keys.map("meshes",
           mesh_record(),
           "Teeth relative to their carrier, the body in which the axes of both gears are fixed; "
           "only meshes that have one.",
           emit_meshes)
      .in_tables_as("mesh")
      .only_if([](const PowerView& v) { return !v.graph.meshes.empty(); });
  keys.custom("arc", row_shape(), "Power of each arc.", write_arc_rows).only_in_tables();
  keys.custom("loop", row_shape(), "Power in circles.", write_loop_rows).only_in_tables();
  keys.part("recirculation", recirculation_record(), [](const PowerView& v) { return v; });
}

}  // namespace kinestat
