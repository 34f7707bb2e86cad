#include <algorithm>

#include "core/utf8.hpp"
#include "core/version.hpp"
#include "couplings/kinds.hpp"
#include "report/report_keys.hpp"

namespace kinestat {

namespace {

struct ParameterView {
  const ParameterDescription& parameter;
  const Quantity* value = nullptr;  // null if it has none
  NamedUnit unit;
};

const Record<ParameterView>& parameter_record() {
  using View = ParameterView;
  static const Record<View> record("One parameter.", [](Record<View>& keys) {
    const auto has_value = [](const View& v) { return v.value != nullptr; };
    keys.text("expression",
              "Its number or expression as typed.",
              [](const View& v) { return v.parameter.value.expression.text(); })
        .not_compared();
    keys.number("value",
                ByContext::beside,
                "Its value.",
                [](const View& v) { return v.unit.scale.written_from_si(v.value->value); })
        .only_if(has_value);
    keys.text("unit",
              "Unit of the value, of the file or else of SI; empty for a bare number.",
              [](const View& v) { return v.unit.text; })
        .not_compared()
        .only_if(has_value);
    keys.flag("free",
              "The file leaves it free: the cases give their dependence on it.",
              [](const View& v) { return v.parameter.is_free; })
        .only_if([](const View& v) { return v.parameter.is_free; });
  });
  return record;
}

void emit_parameters(const HeadView& v, const Each<ParameterView>& each) {
  const ParameterTable table = evaluate_parameters(parameters_of(v.description)).table;
  for (const ParameterDescription& parameter : v.description.parameters) {
    const Quantity* value = table.find(parameter.name.text);
    each(parameter.name.text,
         {.parameter = parameter,
          .value = value,
          .unit = value != nullptr ? v.description.units.unit_of(value->dimension) : NamedUnit{}});
  }
}

const Record<CurveDescription>& curve_record() {
  using View = CurveDescription;
  static const Record<View> record("One curve.", [](Record<View>& keys) {
    const auto has_table = [](const View& v) { return !v.table.empty(); };
    keys.text("over",
              "What it is over: time, an actuator, or its speed.",
              [](const View& v) { return v.over.text; })
        .not_compared();
    keys.count("points", "Number of its points.", [](const View& v) {
      return static_cast<int>(v.points.size());
    });
    keys.text("table",
              "The file of --curve from which it has its points.",
              [](const View& v) { return printable(v.table); })
        .not_compared()
        .only_if(has_table);
    keys.text("sha256", "Of that file, in hexadecimal.", [](const View& v) { return v.table_hash; })
        .only_if(has_table);
  });
  return record;
}

void emit_curves(const HeadView& v, const Each<CurveDescription>& each) {
  for (const CurveDescription& curve : v.description.curves) {
    each(curve.name.text, curve);
  }
}

const Record<FileUnits>& units_record() {
  static const Record<FileUnits> record(
      "Units of the numbers in this report.", [](Record<FileUnits>& keys) {
        for (const QuantityKind kind : all_quantity_kinds()) {
          if (!key_of(kind).empty()) {
            keys.text(std::string(key_of(kind)),
                      std::string("Unit of ") + std::string(phrase_of(kind)) + ".",
                      [kind](const FileUnits& units) { return units.text(kind); });
          }
        }
      });
  return record;
}

struct EdgeView {
  const Mechanism& mechanism;
  std::size_t index = 0;

  const Topology& topology() const { return mechanism.topology; }

  const CouplingTopology& coupling() const { return topology().couplings[index]; }
};

void emit_edge_freedoms(const EdgeView& v, const EachName& each) {
  const CouplingTopology& coupling = v.coupling();
  for (int f = 0; f < coupling.freedom_count; ++f) {
    each(v.topology().freedoms[static_cast<std::size_t>(coupling.first_freedom + f)].name);
  }
}

void emit_edge_actions(const EdgeView& v, bool of_actuators, const EachName& each) {
  const CouplingTopology& coupling = v.coupling();
  for (int a = 0; a < coupling.action_count; ++a) {
    const ActionLabel& action =
        v.topology().actions[static_cast<std::size_t>(coupling.first_action + a)];
    if (of_actuators == (action.actuator >= 0)) {
      each(action.name);
    }
  }
}

template <class Use>
void for_each_driven_freedom(const EdgeView& v, const Use& use) {
  const CouplingTopology& coupling = v.coupling();
  for (int a = 0; a < coupling.action_count; ++a) {
    const int actuator =
        v.topology().actions[static_cast<std::size_t>(coupling.first_action + a)].actuator;
    if (actuator >= 0) {
      const int freedom = v.topology().actuators[static_cast<std::size_t>(actuator)].freedom;
      use(v.topology().freedoms[static_cast<std::size_t>(freedom)]);
    }
  }
}

void emit_driven_freedoms(const EdgeView& v, const EachName& each) {
  for_each_driven_freedom(v, [&](const FreedomLabel& freedom) { each(freedom.name); });
}

bool drives_one_of_two_kinds(const EdgeView& v) {
  const auto first = v.topology().freedoms.begin() + v.coupling().first_freedom;
  const auto count = std::count_if(
      first, first + v.coupling().freedom_count, [](const auto& one) { return one.is_rotation; });
  bool has_actuator = false;
  for_each_driven_freedom(v, [&](const FreedomLabel&) { has_actuator = true; });
  return has_actuator && count != 0 && count != v.coupling().freedom_count;
}

const Record<EdgeView>& edge_record() {
  using View = EdgeView;
  static const Record<View> record(
      "One coupling, an edge from tail to head.", [](Record<View>& keys) {
        keys.text("name", "Name of the coupling.", [](const View& v) { return v.coupling().name; });
        keys.text("type", "Kind of coupling, as in the mechanism file.", [](const View& v) {
          return word_of(v.coupling().type);
        });
        keys.names("bodies",
                   "Tail and head.",
                   [](const View& v, const EachName& each) {
                     each(v.topology().body(v.coupling().tail).name);
                     each(v.topology().body(v.coupling().head).name);
                   })
            .ordered();
        keys.vector(
            "at", QuantityKind::length, "Its point in the drawn position.", [](const View& v) {
              const Geometry& geometry = v.mechanism.geometry;
              return geometry.origin.in_world(geometry.points[v.index]);
            });
        keys.names("freedoms", "Names of its freedoms.", emit_edge_freedoms);
        keys.names("constraints",
                   "Names of its passive actions.",
                   [](const View& v, const EachName& each) { emit_edge_actions(v, false, each); });
        keys.names("actuators",
                   "Names of the actuators on it.",
                   [](const View& v, const EachName& each) { emit_edge_actions(v, true, each); });
        keys.names("driven",
                   "The freedom of each of them; only if the coupling has both rotations and "
                   "translations.",
                   emit_driven_freedoms)
            .ordered()
            .only_if(drives_one_of_two_kinds);
      });
  return record;
}

struct GraphBodyView {
  const std::string& name;
  Vec3 reference = Vec3::Zero();
};

const Record<GraphBodyView>& graph_body_record() {
  static const Record<GraphBodyView> record("One body.", [](Record<GraphBodyView>& keys) {
    keys.text("name", "Name of the body.", [](const GraphBodyView& v) { return v.name; });
    keys.vector("reference",
                QuantityKind::length,
                "The point whose velocity is reported.",
                [](const GraphBodyView& v) { return v.reference; });
  });
  return record;
}

void emit_labels(const std::vector<std::string>& labels, const EachName& each) {
  for (const std::string& label : labels) {
    each(label);
  }
}

void write_entries(const LabelledMatrix& matrix, Archive& to) {
  to.begin_list();
  for (Eigen::Index r = 0; r < matrix.value.rows(); ++r) {
    to.begin_list();
    for (Eigen::Index c = 0; c < matrix.value.cols(); ++c) {
      to.number(matrix.value(r, c), {});
    }
    to.end_list();
  }
  to.end_list();
}

const Record<LabelledMatrix>& matrix_record() {
  using View = LabelledMatrix;
  static const Record<View> record("A matrix with its labels.", [](Record<View>& keys) {
    keys.text("meaning",
              "What the matrix is, in a few words.",
              [](const View& v) { return v.meaning; })
        .not_compared();
    keys.names("rows",
               "Labels of the rows.",
               [](const View& v, const EachName& each) { emit_labels(v.rows, each); })
        .ordered();
    keys.names("columns",
               "Labels of the columns.",
               [](const View& v, const EachName& each) { emit_labels(v.columns, each); })
        .ordered();
    keys.custom("values",
                list_shape(list_shape(number_shape(ByContext::relative, false))),
                "Entries row by row; lengths in the unit of length.",
                write_entries);
  });
  return record;
}

void emit_graph_bodies(const GraphView& v, const Each<GraphBodyView>& each) {
  const Topology& topology = v.mechanism.topology;
  const Geometry& geometry = v.mechanism.geometry;
  for (std::size_t b = 0; b < topology.bodies.size(); ++b) {
    each({.name = topology.bodies[b].name,
          .reference = geometry.origin.in_world(geometry.references[b])});
  }
}

void emit_graph_couplings(const GraphView& v, const Each<EdgeView>& each) {
  for (std::size_t e = 0; e < v.mechanism.topology.couplings.size(); ++e) {
    each({.mechanism = v.mechanism, .index = e});
  }
}

void emit_names_of(const GraphView& v, const std::vector<int>& edges, const EachName& each) {
  for (const int e : edges) {
    each(v.mechanism.topology.couplings[static_cast<std::size_t>(e)].name);
  }
}

void emit_matrices(const GraphView& v, const Each<LabelledMatrix>& each) {
  for (const LabelledMatrix& matrix : v.matrices) {
    each(matrix.symbol, matrix);
  }
}

}  // namespace

const Record<HeadView>& program_record() {
  static const Record<HeadView> record(
      "The program that wrote the report.", [](Record<HeadView>& keys) {
        keys.text("version", "Version of the program.", [](const HeadView&) { return kVersion; });
        keys.count("report",
                   "Version of this format: key order and names are stable within it.",
                   [](const HeadView&) { return kReportVersion; });
      });
  return record;
}

const Record<HeadView>& mechanism_record() {
  static const Record<HeadView> record(
      "The mechanism as its file describes it.", [](Record<HeadView>& keys) {
        keys.text("name",
                  "Title of the mechanism; empty if the file gives none.",
                  [](const HeadView& v) { return v.description.name; });
        keys.text("source",
                  "Where the mechanism and its numbers come from; empty if the file gives none.",
                  [](const HeadView& v) { return v.description.source; });
        keys.text("file",
                  "Path of the file as it was given.",
                  [](const HeadView& v) { return printable(v.file); })
            .not_compared();
        keys.word("space",
                  {"planar", "spatial"},
                  "Whether the mechanism was described in the plane or in space.",
                  [](const HeadView& v) {
                    return v.description.space == Space::planar ? "planar" : "spatial";
                  });
        keys.part("units",
                  units_record(),
                  [](const HeadView& v) -> const FileUnits& { return v.description.units; })
            .not_compared();
        keys.map("parameters",
                 parameter_record(),
                 "Parameters by name, as they were written or replaced by --set, with their "
                 "values.",
                 emit_parameters);
        keys.map("curves", curve_record(), "Curves by name, as they were used.", emit_curves)
            .only_if([](const HeadView& v) { return !v.description.curves.empty(); });
      });
  return record;
}

const Record<GraphView>& graph_record() {
  using View = GraphView;
  static const Record<View> record("The coupling graph.", [](Record<View>& keys) {
    keys.list("bodies", graph_body_record(), "Bodies, the ground first.", emit_graph_bodies);
    keys.list(
        "couplings", edge_record(), "Couplings in the order of the file.", emit_graph_couplings);
    keys.names("tree", "Couplings of the spanning tree.", [](const View& v, const EachName& each) {
      emit_names_of(v, v.mechanism.graph.tree.branches, each);
    });
    keys.names("chords",
               "Couplings that are not in the tree, one a circuit.",
               [](const View& v, const EachName& each) {
                 emit_names_of(v, v.mechanism.graph.tree.chords, each);
               });
    keys.map("matrices",
             matrix_record(),
             "Matrices of Davies' method by their symbols, with 'kinestat graph --matrices': those "
             "of motions and actions in the coordinates of the order (M_D, A_D) and of the network "
             "(M_N, A_N), their echelon forms, and their columns by what is known (NP) and sought "
             "(NS); incidence I, cut-sets Q and circuits B, also repeated for every freedom (B_M) "
             "and action (Q_A).",
             emit_matrices)
        .only_if([](const View& v) { return !v.matrices.empty(); });
  });
  return record;
}

}  // namespace kinestat
