#include "studies/mobility/report/mobility_record.hpp"

#include "couplings/kinds.hpp"
#include "mechanism/label_kind.hpp"
#include "network/evidence_record.hpp"
#include "report/report_keys.hpp"
#include "screw/screw_record.hpp"
#include "studies/mobility/mobility_counts_record.hpp"
#include "studies/mobility/report/mobility_words.hpp"
#include "studies/motion/finite_mobility_record.hpp"

namespace kinestat {

namespace {

const Record<MobilityAnalysis>& grubler_counts_record() {
  using View = MobilityAnalysis;
  static const Record<View> record("Counts without geometry.", [](Record<View>& keys) {
    keys.part("spatial",
              grubler_record(),
              [](const View& v) {
                return GrublerView{.topology = v.mechanism.topology, .count = v.mobility.spatial};
              })
        .in_tables_is(TableRole::element);
    keys.part("planar",
              grubler_record(),
              [](const View& v) {
                return v.mobility.planar
                           ? std::optional(GrublerView{.topology = v.mechanism.topology,
                                                       .count = *v.mobility.planar})
                           : std::nullopt;
              })
        .in_tables_is(TableRole::element);
  });
  return record;
}

const Record<MobilityCounts>& rank_counts_record() {
  using View = MobilityCounts;
  static const Record<View> record(
      "Freedoms and constraints by rank (Davies), as in the report; null for a file without "
      "dimensions.",
      [](Record<View>& keys) {
        keys.include(counts_record(), [](const View& v) -> const View& { return v; });
        keys.part("evidence",
                  rank_evidence_record(),
                  [](const View& v) -> const RankEvidence& { return v.evidence; })
            .not_compared();
      });
  return record;
}

// Redundant constraints in one order.
struct RedundancyView {
  const MobilityAnalysis& analysis;
  const Mechanism& mechanism;  // in that order
  const Redundancies& redundancies;
};

struct RedundantConstraintView {
  const MobilityAnalysis& analysis;
  const Mechanism& mechanism;
  const RedundantConstraint& one;
};

// Of the force or moment that goes round the circuit; without circuit, of the first action.
QuantityKind reference_kind(const RedundantConstraintView& v) {
  if (v.one.axis) {
    return action_kind(!v.one.axis->pitch);
  }
  int first = 0;
  while (v.one.magnitudes[first] == 0.0) {
    ++first;
  }
  return kind_of(v.mechanism.topology.actions[static_cast<std::size_t>(first)]);
}

void emit_shares(const RedundantConstraintView& v, const EachNumber& each) {
  const Topology& topology = v.mechanism.topology;
  const double unit = v.analysis.description.units.factor(reference_kind(v));
  for (int a = 0; a < topology.action_count(); ++a) {
    if (v.one.magnitudes[a] != 0.0) {
      each(topology.action_name(a),
           v.one.magnitudes[a] * unit,
           kind_of(topology.actions[static_cast<std::size_t>(a)]));
    }
  }
}

const Record<RedundantConstraintView>& redundant_constraint_record() {
  using View = RedundantConstraintView;
  static const Record<View> record(
      "Actions in equilibrium with each other alone.", [](Record<View>& keys) {
        keys.text("name",
                  "The direction in words, for example couple about x; empty where it flows "
                  "through several circuits.",
                  [](const View& v) { return constraint_words(v.analysis, v.one); })
            .not_compared();  // it has lengths in the unit of the file
        keys.text("circuit",
                  "The coupling that closes its circuit; null where it flows through several.",
                  [](const View& v) {
                    return v.one.chord
                               ? std::optional(v.mechanism.topology.coupling(*v.one.chord).name)
                               : std::nullopt;
                  })
            .not_in_tables();
        keys.part("screw", axis_record(), [](const View& v) {
          return view_of(v.one.axis, v.mechanism.geometry.origin);
        });
        keys.text(
                "per",
                "The unit of the wrench, or of the first action where it flows through several "
                "circuits: the shares go with 1 of it.",
                [](const View& v) { return v.analysis.description.units.text(reference_kind(v)); })
            .reference_unit()
            .not_compared();
        keys.numbers("actions",
                     ByContext::action,
                     "Contributions by the name of the action, in the units of the file: for one "
                     "unit of the wrench, or of the first action where it flows through several "
                     "circuits.",
                     emit_shares);
      });
  return record;
}

void emit_constraints(const RedundancyView& v, const Each<RedundantConstraintView>& each) {
  for (const RedundantConstraint& one : v.redundancies.constraints) {
    each({.analysis = v.analysis, .mechanism = v.mechanism, .one = one});
  }
}

const Record<RedundancyView>& redundancy_record() {
  using View = RedundancyView;
  static const Record<View> record("Redundant constraints in one order.", [](Record<View>& keys) {
    keys.count("order", "Order of the space.", [](const View& v) { return v.redundancies.order; });
    keys.count("count", "C_N: number of redundant constraints.", [](const View& v) {
      return v.redundancies.net_constraint;
    });
    keys.count("borne",
               "How many of them couplings bear; the others belong to the model of gears, clutches "
               "and 'passive' alone.",
               [](const View& v) { return v.redundancies.borne; });
    keys.list("self_stresses",
              redundant_constraint_record(),
              "One for each that is borne; empty if they are too many to list.",
              emit_constraints)
        .ordered();
  });
  return record;
}

const Record<MobilityAnalysis>& redundancies_record() {
  using View = MobilityAnalysis;
  static const Record<View> record(
      "Redundant constraints by name, in space, in the plane (null for a mechanism that leaves it) "
      "and in the smallest screw system that holds all motions; null for a file without "
      "dimensions.",
      [](Record<View>& keys) {
        const auto of = [](const View& v, const Mechanism& mechanism, const Redundancies& which) {
          return RedundancyView{.analysis = v, .mechanism = mechanism, .redundancies = which};
        };
        keys.part("spatial",
                  redundancy_record(),
                  [of](const View& v) { return of(v, v.in_space, v.mobility.exact->spatial); })
            .in_tables_is(TableRole::element);
        keys.part("planar",
                  redundancy_record(),
                  [of](const View& v) {
                    const std::optional<Redundancies>& planar = v.mobility.exact->planar;
                    return planar ? std::optional(of(v, v.mechanism, *planar)) : std::nullopt;
                  })
            .in_tables_is(TableRole::element);
        keys.part("minimal",
                  redundancy_record(),
                  [of](const View& v) { return of(v, v.mechanism, v.mobility.exact->minimal); })
            .in_tables_is(TableRole::element);
      });
  return record;
}

const Record<CouplingChange>& coupling_change_record() {
  using View = CouplingChange;
  static const Record<View> record("One changed coupling.", [](Record<View>& keys) {
    keys.text("to",
              "The type that it becomes; null if none in the catalogue fits.",
              [](const View& v) { return v.to ? std::optional(word_of(*v.to)) : std::nullopt; })
        .in_tables_is(TableRole::word);
    keys.flag("left_out",
              "Whether it would no longer carry anything, so that it can be left out.",
              [](const View& v) { return v.is_left_out; })
        .in_tables_is(TableRole::word);
    keys.names("added",
               "Its additional freedoms, in words.",
               [](const View& v, const EachName& each) {
                 for (const Twist& twist : v.added) {
                   each(freedom_words(twist));
                 }
               })
        .in_tables_is(TableRole::word);
  });
  return record;
}

struct RepairView {
  const Topology& topology;
  const Repair& repair;
};

void emit_changes(const RepairView& v, const Each<CouplingChange>& each) {
  for (const CouplingChange& change : v.repair.changes) {
    each(v.topology.coupling(change.coupling).name, change);
  }
}

const Record<RepairView>& repair_record() {
  using View = RepairView;
  static const Record<View> record("One set of changes.", [](Record<View>& keys) {
    keys.map(
        "changes", coupling_change_record(), "Changes by the name of the coupling.", emit_changes);
    keys.count("removes", "Number of redundant constraints that it removes.", [](const View& v) {
      return v.repair.freed;
    });
    keys.count("net_freedom",
               "F_N of the released mechanism in space, recalculated.",
               [](const View& v) { return v.repair.after.net_freedom; });
    keys.count("net_constraint",
               "C_N of the released mechanism in space, recalculated.",
               [](const View& v) { return v.repair.after.net_constraint; });
    keys.flag("verified",
              "Whether the released mechanism has the same mobility and this number of redundant "
              "constraints fewer.",
              [](const View& v) { return v.repair.is_verified; })
        .in_tables_is(TableRole::word);
  });
  return record;
}

bool has_geometry(const MobilityAnalysis& v) {
  return v.mobility.exact.has_value();
}

std::optional<ReshetovView> reshetov_of(const MobilityAnalysis& v) {
  if (!v.mobility.reshetov) {
    return {};
  }
  return ReshetovView{.topology = v.in_space.topology,
                      .table = *v.mobility.reshetov,
                      .exact = has_geometry(v)
                                   ? std::optional(v.mobility.exact->counts.spatial.motions)
                                   : std::nullopt};
}

void add_counts(Record<MobilityAnalysis>& keys) {
  using View = MobilityAnalysis;
  keys.part("grubler", grubler_counts_record(), [](const View& v) -> const View& { return v; })
      .in_tables_is(TableRole::element);
  keys.count("circuits", "Number of independent circuits.", [](const View& v) {
    return v.mechanism.graph.circuit_count();
  });
  keys.part("counts",
            rank_counts_record(),
            [](const View& v) {
              return has_geometry(v) ? std::optional(v.mobility.exact->counts) : std::nullopt;
            })
      .in_tables_is(TableRole::element);
  keys.part("reshetov", reshetov_record(), reshetov_of).in_tables_is(TableRole::element);
}

void add_motions(Record<MobilityAnalysis>& keys) {
  using View = MobilityAnalysis;
  keys.list("motions",
            free_motion_record(),
            "Independent motions at the drawn position, passive ones last; empty if there are none "
            "or too many to list, null for a file without dimensions.",
            [](const View& v, const Each<FreeMotionView>& each) {
              for (const FreeMotion& motion : v.mobility.exact->motions.motions) {
                each({.mechanism = v.mechanism, .motion = motion, .units = v.description.units});
              }
            })
      .null_unless(has_geometry)
      .in_tables_is(TableRole::element);
  keys.part("finite",
            finite_mobility_record(),
            [](const View& v) {
              return v.finite ? std::optional(FiniteMobilityView{.topology = v.mechanism.topology,
                                                                 .finite = *v.finite})
                              : std::nullopt;
            })
      .in_tables_is(TableRole::element);
}

void add_redundancies(Record<MobilityAnalysis>& keys) {
  using View = MobilityAnalysis;
  keys.part("redundancies", redundancies_record(), [](const View& v) -> const View& { return v; })
      .null_unless(has_geometry)
      .in_tables_is(TableRole::element);
  keys.list("repairs",
            repair_record(),
            "Sets of changes each of which removes all that is redundant in space and leaves the "
            "mobility as it is, the cheapest first; null for a file without dimensions.",
            [](const View& v, const Each<RepairView>& each) {
              for (const Repair& repair : v.mobility.exact->repairs) {
                each({.topology = v.mechanism.topology, .repair = repair});
              }
            })
      .null_unless(has_geometry)
      .in_tables_is(TableRole::element);
  keys.names("remarks",
             "How the counts are related, in sentences.",
             [](const View& v, const EachName& each) {
               for (const std::string& remark : mobility_remarks(v)) {
                 each(remark);
               }
             });
}

const Record<MobilityAnalysis>& mobility_analysis_record() {
  static const Record<MobilityAnalysis> record("What moves and what is redundant.",
                                               [](Record<MobilityAnalysis>& keys) {
                                                 add_counts(keys);
                                                 add_motions(keys);
                                                 add_redundancies(keys);
                                               });
  return record;
}

}  // namespace

const Record<MobilityReportView>& mobility_report_record() {
  using View = MobilityReportView;
  static const Record<View> record(
      "What 'kinestat mobility --format json' writes: counts, motions, redundant constraints by "
      "name, and which releases would remove them.",
      [](Record<View>& keys) {
        add_head(keys);
        keys.part("mobility",
                  mobility_analysis_record(),
                  [](const View& v) -> const MobilityAnalysis& { return v.analysis; })
            .in_tables_is(TableRole::table);
        add_diagnostics(keys);
      });
  return record;
}

}  // namespace kinestat
