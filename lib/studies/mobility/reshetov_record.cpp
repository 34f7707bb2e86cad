#include "studies/mobility/mobility_counts_record.hpp"

namespace kinestat {

namespace {

struct ReshetovCircuitView {
  const Topology& topology;
  const ReshetovCircuit& circuit;
};

// "rotation about x"
std::string closure_words(std::size_t closure) {
  const std::string axis(1, static_cast<char>('x' + static_cast<int>(closure % 3)));
  return (closure < 3 ? "rotation about " : "translation along ") + axis;
}

const Record<ReshetovCircuit>& offered_record() {
  using View = ReshetovCircuit;
  static const Record<View> record(
      "How many freedoms its couplings offer along the world axes.", [](Record<View>& keys) {
        for (std::size_t i = 0; i < kClosures.size(); ++i) {
          keys.count(kClosures[i], "Offered: " + closure_words(i) + ".", [i](const View& v) {
            return v.offered[i];
          });
        }
      });
  return record;
}

const Record<ReshetovCircuitView>& cover_record() {
  using View = ReshetovCircuitView;
  static const Record<View> record(
      "Which freedom covers each demand; null: none.", [](Record<View>& keys) {
        for (std::size_t i = 0; i < kClosures.size(); ++i) {
          keys.text(kClosures[i], "Covered by: " + closure_words(i) + ".", [i](const View& v) {
            const std::optional<int>& cover = v.circuit.covered_by[i];
            return cover ? std::optional(v.topology.freedom_name(*cover)) : std::nullopt;
          });
        }
      });
  return record;
}

void emit_circuit(const ReshetovCircuitView& v, const EachName& each) {
  for (const CouplingId id : v.circuit.couplings) {
    each(v.topology.coupling(id).name);
  }
}

void write_missing(const ReshetovCircuitView& v, Archive& to) {
  to.begin_list();
  for (std::size_t i = 0; i < kClosures.size(); ++i) {
    if (!v.circuit.covered_by[i]) {
      to.text(kClosures[i]);
    }
  }
  to.end_list();
}

const Record<ReshetovCircuitView>& reshetov_circuit_record() {
  using View = ReshetovCircuitView;
  static const Record<View> record("One circuit.", [](Record<View>& keys) {
    keys.names("couplings", "Couplings of the circuit.", emit_circuit);
    keys.part("offered", offered_record(), [](const View& v) -> const ReshetovCircuit& {
      return v.circuit;
    });
    keys.part("covered_by", cover_record(), [](const View& v) { return v; }).not_in_tables();
    keys.custom("missing",
                list_shape(word_shape({kClosures.begin(), kClosures.end()}, false)),
                "Demands that nothing covers.",
                write_missing);
    keys.count("oblique_rotations", "Rotations about no world axis.", [](const View& v) {
      return v.circuit.oblique_rotations;
    });
    keys.count("oblique_translations", "Translations along no world axis.", [](const View& v) {
      return v.circuit.oblique_translations;
    });
  });
  return record;
}

void emit_circuits(const ReshetovView& v, const Each<ReshetovCircuitView>& each) {
  for (const ReshetovCircuit& circuit : v.table.circuits) {
    each(v.topology.coupling(circuit.chord).name, {.topology = v.topology, .circuit = circuit});
  }
}

std::optional<bool> agrees(const ReshetovView& v) {
  return v.exact ? std::optional(v.table.mobility == v.exact->net_freedom &&
                                 v.table.redundant == v.exact->net_constraint)
                 : std::nullopt;
}

}  // namespace

const Record<ReshetovView>& reshetov_record() {
  using View = ReshetovView;
  static const Record<View> record(
      "Table of Reshetov: which freedoms close each circuit without force; null where directions "
      "are not known.",
      [](Record<View>& keys) {
        keys.count("mobility", "Number of freedoms left over.", [](const View& v) {
          return v.table.mobility;
        });
        keys.count("redundant", "Number of demands that nothing covers.", [](const View& v) {
          return v.table.redundant;
        });
        keys.map("circuits",
                 reshetov_circuit_record(),
                 "Circuits by the name of the coupling that closes them.",
                 emit_circuits);
        keys.names(
            "unused", "Freedoms that are left over.", [](const View& v, const EachName& each) {
              for (const int f : v.table.unused) {
                each(v.topology.freedom_name(f));
              }
            });
        keys.flag("agrees",
                  "Whether the table agrees with the counts in space; null for a file without "
                  "dimensions.",
                  agrees);
      });
  return record;
}

}  // namespace kinestat
