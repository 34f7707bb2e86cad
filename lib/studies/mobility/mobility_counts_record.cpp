#include "studies/mobility/mobility_counts_record.hpp"

namespace kinestat {

namespace {

const Record<ActionCounts>& action_counts_record() {
  static const Record<ActionCounts> record(
      "The same for the actions; null where the actions need more than this order.",
      [](Record<ActionCounts>& keys) {
        keys.count("order",
                   "Order of the screw system in which the actions are counted.",
                   [](const ActionCounts& v) { return v.order; });
        keys.count("gross_constraint",
                   "C: sum of the actions of all couplings, those of actuators included.",
                   [](const ActionCounts& v) { return v.gross_constraint; });
        keys.count("rank", "a: rank of the action network matrix.", [](const ActionCounts& v) {
          return v.rank;
        });
        keys.count("net_constraint",
                   "C_N = C - a: number of actions that must be known.",
                   [](const ActionCounts& v) { return v.net_constraint; });
        keys.count("net_freedom",
                   "F_N = order times branches - a: motions that no action resists.",
                   [](const ActionCounts& v) { return v.net_freedom; });
      });
  return record;
}

const Record<SideCounts>& side_record() {
  static const Record<SideCounts> record(
      "Freedoms and constraints in one screw system; counts without unit.",
      [](Record<SideCounts>& keys) {
        keys.count("order",
                   "Order of the screw system in which the motions are counted.",
                   [](const SideCounts& v) { return v.motions.order; });
        keys.count("gross_freedom",
                   "F: sum of the freedoms of all couplings.",
                   [](const SideCounts& v) { return v.motions.gross_freedom; });
        keys.count("rank", "m: rank of the motion network matrix.", [](const SideCounts& v) {
          return v.motions.rank;
        });
        keys.count("net_freedom", "F_N = F - m: mobility.", [](const SideCounts& v) {
          return v.motions.net_freedom;
        });
        keys.count("net_constraint",
                   "C_N = order times circuits - m: redundant constraints.",
                   [](const SideCounts& v) { return v.motions.net_constraint; });
        keys.part("statics", action_counts_record(), [](const SideCounts& v) { return v.actions; });
      });
  return record;
}

}  // namespace

const Record<MobilityCounts>& counts_record() {
  using View = MobilityCounts;
  static const Record<View> record(
      "Freedoms and constraints by rank; counts without unit.", [](Record<View>& keys) {
        keys.part("minimal", side_record(), [](const View& v) { return v.minimal; })
            .in_tables_is(TableRole::element);
        keys.part("planar", side_record(), [](const View& v) { return v.planar; })
            .in_tables_is(TableRole::element);
        keys.part("spatial", side_record(), [](const View& v) { return v.spatial; })
            .in_tables_is(TableRole::element);
      });
  return record;
}

}  // namespace kinestat
