#include "studies/motion/finite_mobility_record.hpp"

namespace kinestat {

namespace {

const Record<FreedomTrial>& freedom_trial_record() {
  using View = FreedomTrial;
  static const Record<View> record("One motion.", [](Record<View>& keys) {
    keys.word("persistence",
              words_up_to(Persistence::instantaneous),
              "finite: the mechanism can follow it; deflected: it moves, but leaves this direction "
              "at once; instantaneous: no nearby position closes.",
              [](const View& v) { return word_of(v.persistence); })
        .in_tables_is(TableRole::word);
    keys.number("step",
                Bare::number,
                "How far it was followed: the largest rotation in radians, or translation as a "
                "fraction of the mechanism's size.",
                [](const View& v) { return v.step; });
    keys.number("closure_error",
                Bare::number,
                "The gap left after closing, as a fraction of the mechanism's size.",
                [](const View& v) { return v.closure_error; })
        .not_compared();
  });
  return record;
}

void emit_trials(const FiniteMobilityView& v, const Each<FreedomTrial>& each) {
  for (const FreedomTrial& trial : v.finite.trials) {
    each(trial);
  }
}

void emit_gained(const FiniteMobilityView& v, const EachName& each) {
  for (const CouplingId id : v.finite.gained) {
    each(v.topology.coupling(id).name);
  }
}

}  // namespace

const Record<FiniteMobilityView>& finite_mobility_record() {
  using View = FiniteMobilityView;
  static const Record<View> record(
      "Whether the motions go on beyond the instant, and whether the drawn position is singular; "
      "null where a coupling cannot be moved and for a file without dimensions.",
      [](Record<View>& keys) {
        keys.list("motions", freedom_trial_record(), "One a motion, in their order.", emit_trials);
        keys.count("drawn_freedom",
                   "Net degree of freedom in the drawn position.",
                   [](const View& v) { return v.finite.drawn_freedom; });
        keys.count("nearby_freedom",
                   "The least at nearby positions; 0 if nothing moves.",
                   [](const View& v) { return v.finite.nearby_freedom; });
        keys.flag("singular",
                  "Whether the drawn position has more freedoms than those close by.",
                  [](const View& v) { return v.finite.is_singular(); })
            .in_tables_is(TableRole::word);
        keys.names("gained", "Couplings that move in the drawn position only.", emit_gained)
            .in_tables_is(TableRole::word);
      });
  return record;
}

}  // namespace kinestat
