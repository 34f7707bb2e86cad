#include "studies/mobility/mobility_counts_record.hpp"

namespace kinestat {

namespace {

struct PairClassView {
  const Topology& topology;
  const PairClass& pairs;
};

const Record<PairClassView>& pair_class_record() {
  using View = PairClassView;
  static const Record<View> record("One class.", [](Record<View>& keys) {
    keys.names("couplings", "Names of its couplings.", [](const View& v, const EachName& each) {
      for (const CouplingId id : v.pairs.couplings) {
        each(v.topology.coupling(id).name);
      }
    });
    keys.count("freedoms", "Sum of their freedoms in the order of this count.", [](const View& v) {
      return v.pairs.freedoms;
    });
  });
  return record;
}

void emit_classes(const GrublerView& v, const Each<PairClassView>& each) {
  for (std::size_t i = 0; i < v.count.classes.size(); ++i) {
    if (!v.count.classes[i].couplings.empty()) {
      each(name_of_class(i), {.topology = v.topology, .pairs = v.count.classes[i]});
    }
  }
}

}  // namespace

const Record<GrublerView>& grubler_record() {
  using View = GrublerView;
  static const Record<View> record(
      "Count of Grübler and Kutzbach, M = order (bodies - 1 - couplings) + freedoms.",
      [](Record<View>& keys) {
        keys.count("order", "Order of the space: 6, or 3 in the plane.", [](const View& v) {
          return v.count.order;
        });
        keys.count("bodies", "Number of bodies, the ground included.", [](const View& v) {
          return v.count.bodies;
        });
        keys.count(
            "couplings", "Number of couplings.", [](const View& v) { return v.count.couplings; });
        keys.count("freedoms", "Sum of the freedoms of all couplings.", [](const View& v) {
          return v.count.freedoms;
        });
        keys.count("mobility",
                   "M, the mobility if every constraint were independent; it equals F_N - C_N.",
                   [](const View& v) { return v.count.mobility; })
            .at_least({});
        keys.map("classes",
                 pair_class_record(),
                 "Couplings by class: P_I prevents one motion in space, P_V five. Only classes "
                 "that occur.",
                 emit_classes);
      });
  return record;
}

}  // namespace kinestat
