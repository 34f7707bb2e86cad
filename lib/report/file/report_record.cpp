#include "report/file/report_record.hpp"

#include "cases/report/case_record.hpp"
#include "cases/report/planet_fit_record.hpp"
#include "network/evidence_record.hpp"
#include "report/report_keys.hpp"
#include "studies/mobility/mobility_counts_record.hpp"
#include "studies/motion/report/motion_record.hpp"
#include "studies/shift/report/shift_record.hpp"

namespace kinestat {

namespace {

const Record<RankCertainty>& rank_record() {
  using View = RankCertainty;
  static const Record<View> record(
      "Of a network matrix; null where it is not examined.", [](Record<View>& keys) {
        keys.count("value",
                   "The rank, by elimination of the numbers rounded to double.",
                   [](const View& v) { return v.rank; });
        keys.word("how",
                  {"structural", "elimination", "modular", "digits", "numeric"},
                  "Its evidence: proved by the pattern of the equations, by elimination without "
                  "rounding, modulo random primes, by numbers of 60 digits, or by the doubles "
                  "alone.",
                  [](const View& v) { return v.how; });
        keys.count("lower",
                   "Least rank that is proved of the rounded numbers; 0 if none is.",
                   [](const View& v) { return v.lower; });
        keys.count("upper",
                   "Largest rank that the pattern of the equations allows.",
                   [](const View& v) { return v.upper; });
        keys.count("as_typed",
                   "The rank of the numbers as typed; null if it was not needed, or would take too "
                   "long.",
                   [](const View& v) {
                     return v.exact_input ? std::optional(v.exact_input->rank) : std::nullopt;
                   });
        keys.number("error_probability",
                    Bare::number,
                    "Probability, over the random choice of primes, that the rank as typed is "
                    "larger than stated.",
                    [](const View& v) {
                      return v.exact_input ? std::optional(v.exact_input->error_probability)
                                           : std::nullopt;
                    })
            .at_least(0);
      });
  return record;
}

const Record<Certainty>& certainty_record() {
  static const Record<Certainty> record(
      "What is proved of the ranks; absent with --accuracy fast.", [](Record<Certainty>& keys) {
        keys.part("motions", rank_record(), [](const Certainty& v) { return v.motion_rank; });
        keys.part("actions", rank_record(), [](const Certainty& v) { return v.action_rank; });
      });
  return record;
}

struct MobilityView {
  const MobilityCounts& counts;
  const Certainty* certainty = nullptr;
};

const Record<MobilityView>& count_evidence_record() {
  using View = MobilityView;
  static const Record<View> record(rank_evidence_record().meaning, [](Record<View>& keys) {
    keys.include(rank_evidence_record(),
                 [](const View& v) -> const RankEvidence& { return v.counts.evidence; });
    keys.part("certainty",
              certainty_record(),
              [](const View& v) -> const Certainty& { return *v.certainty; })
        .only_if([](const View& v) {
          return v.certainty != nullptr && v.certainty->motion_rank.has_value();
        });
  });
  return record;
}

const Record<MobilityView>& mobility_record() {
  using View = MobilityView;
  static const Record<View> record(
      "Freedoms and constraints by rank; counts without unit.", [](Record<View>& keys) {
        keys.include(counts_record(),
                     [](const View& v) -> const MobilityCounts& { return v.counts; });
        keys.part("evidence", count_evidence_record(), [](const View& v) { return v; })
            .not_in_tables()
            .not_compared();
      });
  return record;
}

void add_graph(Record<ReportView>& keys) {
  keys.part("graph",
            graph_record(),
            [](const ReportView& v) {
              return GraphView{.mechanism = *v.mechanism, .matrices = v.matrices};
            })
      .not_in_tables()
      .only_if([](const ReportView& v) { return v.mechanism != nullptr; });
}

void add_analysis(Record<ReportView>& keys) {
  const auto has_analysis = [](const ReportView& v) { return v.analysis != nullptr; };
  keys.part("mobility",
            mobility_record(),
            [](const ReportView& v) {
              return MobilityView{.counts = v.analysis->mobility, .certainty = v.certainty};
            })
      .in_tables_is(TableRole::table)
      .only_if(has_analysis);
  keys.map("planets",
           planet_fit_record(),
           "Several equal planets of 'gears' by the member that has their count; no key without "
           "any.",
           [](const ReportView& v, const Each<PlanetFit>& each) {
             for (const PlanetFit& one : find_planet_fits(v.analysis->description)) {
               each(one.planet, one);
             }
           })
      .not_in_tables()
      .only_if([](const ReportView& v) {
        return v.analysis != nullptr && has_planets(v.analysis->mechanism);
      });
  keys.map("cases",
           case_record(),
           "Cases by label; a pass that a case does not request has no key.",
           [](const ReportView& v, const Each<CaseView>& each) {
             for (const CaseAnalysis& one : v.analysis->cases) {
               each(one.which.label,
                    {.mechanism = v.analysis->mechanism,
                     .units = v.analysis->description.units,
                     .one = one,
                     .analysis = v.analysis});
             }
           })
      .in_tables_is(TableRole::cases)
      .only_if(has_analysis);
}

}  // namespace

const Record<ReportView>& report_record() {
  static const Record<ReportView> record(
      "What 'kinestat analyze --format json' and 'kinestat graph --format json' write for one "
      "mechanism file. Values are in the units that mechanism.units names; vectors are in the "
      "world frame.",
      [](Record<ReportView>& keys) {
        add_head(keys);
        add_graph(keys);
        add_analysis(keys);
        keys.part("shift",
                  shift_record(),
                  [](const ReportView& v) -> const Analysis& { return *v.transmission; })
            .in_tables_is(TableRole::table)
            .only_if([](const ReportView& v) { return v.transmission != nullptr; });
        keys.part("motion",
                  motion_record(),
                  [](const ReportView& v) -> const MotionTable& { return *v.motion; })
            .not_in_tables()
            .only_if([](const ReportView& v) { return v.motion != nullptr; });
        add_diagnostics(keys).only_if([](const ReportView& v) { return v.found != nullptr; });
      });
  return record;
}

}  // namespace kinestat
