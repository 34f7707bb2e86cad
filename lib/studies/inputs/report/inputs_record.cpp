#include "studies/inputs/report/inputs_record.hpp"

#include <fmt/format.h>

#include "mechanism/label_kind.hpp"
#include "network/evidence_record.hpp"
#include "report/report_keys.hpp"

namespace kinestat {

namespace {

struct InputSetView {
  const InputSide& side;
  const InputSet& set;
};

struct InputGroupView {
  const InputSide& side;
  const InputGroup& group;
};

// With what is said of the sets that were proposed.
struct InputSideView {
  const InputSide& side;
  const std::vector<ChoiceVerdict>& choices;
};

void emit_names(const std::vector<int>& magnitudes, const InputSide& side, const EachName& each) {
  for (const int m : magnitudes) {
    each(side.names[static_cast<std::size_t>(m)]);
  }
}

const Record<InputSetView>& input_set_record() {
  using View = InputSetView;
  static const Record<View> record("One set.", [](Record<View>& keys) {
    keys.names("magnitudes", "Its magnitudes.", [](const View& v, const EachName& each) {
      emit_names(v.set.magnitudes, v.side, each);
    });
    keys.number("conditioning",
                Bare::number,
                "Smallest singular value of the secondary system with orthonormal equations, "
                "lengths counted in the mechanism's size: 1 at best, 0 at a dead point.",
                [](const View& v) { return v.set.conditioning; })
        .at_least(0);
  });
  return record;
}

const Record<InputGroupView>& input_group_record() {
  using View = InputGroupView;
  static const Record<View> record("One group.", [](Record<View>& keys) {
    keys.count("needed",
               "How many magnitudes of the group determine the others.",
               [](const View& v) { return v.group.needed; });
    keys.names("magnitudes", "All of the group.", [](const View& v, const EachName& each) {
      emit_names(v.group.magnitudes, v.side, each);
    });
    keys.count(
        "count", "Number of sets of the group.", [](const View& v) { return v.group.count; });
    keys.flag("complete",
              "Whether the count is exact; otherwise there are more.",
              [](const View& v) { return v.group.is_complete; });
    keys.list("sets",
              input_set_record(),
              "The best conditioned sets, the best first; at most as many as --limit says.",
              [](const View& v, const Each<InputSetView>& each) {
                for (const InputSet& set : v.group.best) {
                  each({.side = v.side, .set = set});
                }
              });
  });
  return record;
}

// Tables: a number with a status of its own.
void write_with_status(std::string_view status, std::int64_t value, Archive& to) {
  to.begin_map();
  to.element("", status);
  to.whole(value);
  to.end_map();
}

void write_count(const InputSideView& v, Archive& to) {
  write_with_status(v.side.sets.is_complete() ? "" : "at least",
                    static_cast<std::int64_t>(v.side.sets.count()),
                    to);
}

// Tables: the set is the element, its names joined by blanks.
void write_conditionings(const InputSideView& v, Archive& to) {
  to.begin_map();
  for (const InputGroup& group : v.side.sets.groups) {
    for (const InputSet& set : group.best) {
      std::vector<std::string_view> names;
      for (const int m : set.magnitudes) {
        names.emplace_back(v.side.names[static_cast<std::size_t>(m)]);
      }
      to.element(fmt::format("{}", fmt::join(names, " ")), {});
      to.number(set.conditioning, {});
    }
  }
  for (const ChoiceVerdict& choice : v.choices) {
    if (choice.key == v.side.key) {
      to.element(fmt::format("{}", fmt::join(choice.names, " ")),
                 choice.is_valid ? "chosen" : "not valid");
      to.number(choice.is_valid ? std::optional(choice.conditioning) : std::nullopt, {});
    }
  }
  to.end_map();
}

void add_sets(Record<InputSideView>& keys) {
  using View = InputSideView;
  keys.count("needed",
             "How many magnitudes determine all others: F_N of the motions, C_N of the actions.",
             [](const View& v) { return v.side.sets.needed; });
  keys.names("always_zero",
             "Magnitudes that are zero whatever the others are.",
             [](const View& v, const EachName& each) {
               emit_names(v.side.sets.always_zero, v.side, each);
             });
  keys.count("count",
             "Number of sets: the product over the groups, at most 2^53.",
             [](const View& v) { return v.side.sets.count(); })
      .not_in_tables();
  keys.custom("count", whole_shape(false), "With its status.", write_count).only_in_tables();
  keys.flag("complete", "Whether the count is exact; otherwise there are more.", [](const View& v) {
    return v.side.sets.is_complete();
  });
  keys.list("groups",
            input_group_record(),
            "Magnitudes that depend on each other and on no others; a set takes one set of each "
            "group.",
            [](const View& v, const Each<InputGroupView>& each) {
              for (const InputGroup& group : v.side.sets.groups) {
                each({.side = v.side, .group = group});
              }
            })
      .not_in_tables();
}

const Record<InputSideView>& input_side_record() {
  using View = InputSideView;
  static const Record<View> record(
      "Sets of primary motions, cobases of M_N, or of primary actions, cobases of A_N.",
      [](Record<View>& keys) {
        add_sets(keys);
        keys.custom("conditioning",
                    map_shape(number_shape(Bare::number, true)),
                    "By the names of the set.",
                    write_conditionings)
            .only_in_tables();
        keys.part("evidence",
                  rank_evidence_record(),
                  [](const View& v) -> const RankEvidence& { return v.side.evidence; })
            .not_in_tables()
            .not_compared();
      });
  return record;
}

// Actions are for one unit of force in each segment.
struct CableTensionView {
  const InputsAnalysis& inputs;
  const CableTension& cables;
  const FileUnits& units;
};

void emit_drives(const CableTensionView& v, const EachNumber& each) {
  for (const TensioningDrive& drive : v.cables.drives) {
    each(v.inputs.sides.front().names[static_cast<std::size_t>(drive.freedom)],
         drive.action * v.units.factor(QuantityKind::force),
         action_kind(drive.is_couple));
  }
}

void write_actuators(const CableTensionView& v, Archive& to) {
  if (v.cables.is_possible) {
    write_with_status(v.cables.is_least() ? "" : "at most", v.cables.actuators, to);
    return;
  }
  to.begin_map();
  to.element("", "none");
  to.null();
  to.end_map();
}

void add_actuators(Record<CableTensionView>& keys) {
  using View = CableTensionView;
  keys.count("actuators",
             "The number that determines all motions and pretensions every segment: F_N, and one "
             "more for each dependence of the drives. Null if this is not possible.",
             [](const View& v) {
               return v.cables.is_possible ? std::optional(v.cables.actuators) : std::nullopt;
             })
      .not_in_tables();
  keys.custom("actuators", whole_shape(true), "With its status.", write_actuators).only_in_tables();
  keys.flag("least",
            "No smaller number does; false: another choice of drives might need fewer.",
            [](const View& v) { return v.cables.is_possible && v.cables.is_least(); });
  keys.text("per",
            "The unit of force: the drives belong to a tension of at least 1 of it in each "
            "segment; no key without drives.",
            [](const View& v) { return v.units.text(QuantityKind::force); })
      .only_if([](const View& v) { return !v.cables.drives.empty(); })
      .reference_unit()
      .not_compared();
  keys.numbers("drives",
               ByContext::action,
               "Freedoms whose actuators pull against each other, with their actions, of tail on "
               "head, for that tension; empty where the cables keep themselves in tension.",
               emit_drives);
}

const Record<CableTensionView>& cable_tension_record() {
  using View = CableTensionView;
  static const Record<View> record(
      "Number of actuators that keep every cable segment in tension: a pretension that pulls on "
      "each without a load, and what it requires; no key without cables.",
      [](Record<View>& keys) {
        keys.count("segments", "Straight segments of all cables.", [](const View& v) {
          return v.cables.segments;
        });
        keys.count("net_freedom",
                   "F_N: the number of actuators that determine all motions.",
                   [](const View& v) { return v.cables.net_freedom; });
        keys.count("without_slip", "F_N if no cable slipped on its pulley.", [](const View& v) {
          return v.cables.without_slip;
        });
        keys.flag("possible",
                  "Whether some pretension without loads pulls on every segment.",
                  [](const View& v) { return v.cables.is_possible; });
        add_actuators(keys);
      });
  return record;
}

const InputSide* find_side(const InputsReportView& v, std::string_view key) {
  for (const InputSide& side : v.inputs.sides) {
    if (side.key == key) {
      return &side;
    }
  }
  return nullptr;
}

const Record<InputsReportView>& sides_record() {
  using View = InputsReportView;
  static const Record<View> record("The sets of each side.", [](Record<View>& keys) {
    for (const char* side : {"motion", "action"}) {
      keys.part(side,
                input_side_record(),
                [side](const View& v) {
                  return InputSideView{.side = *find_side(v, side), .choices = v.inputs.choices};
                })
          .only_if([side](const View& v) { return find_side(v, side) != nullptr; });
    }
    keys.part("cables",
              cable_tension_record(),
              [](const View& v) {
                return CableTensionView{
                    .inputs = v.inputs, .cables = *v.inputs.cables, .units = v.description.units};
              })
        .only_if([](const View& v) { return v.inputs.cables.has_value(); });
  });
  return record;
}

const Record<ChoiceVerdict>& choice_record() {
  using View = ChoiceVerdict;
  static const Record<View> record("One set on one side.", [](Record<View>& keys) {
    const auto is_valid = [](const View& v) { return v.is_valid; };
    const auto is_not_valid = [](const View& v) { return !v.is_valid; };
    keys.word("side", {"motion", "action"}, "The side on which it was judged.", [](const View& v) {
      return v.key;
    });
    keys.names("magnitudes", "Its magnitudes.", [](const View& v, const EachName& each) {
      for (const std::string& name : v.names) {
        each(name);
      }
    });
    keys.flag("valid", "Whether it determines all others and is independent.", is_valid);
    keys.number("conditioning",
                Bare::number,
                "Of a valid set.",
                [](const View& v) { return v.conditioning; })
        .at_least(0)
        .only_if(is_valid);
    keys.text("reason",
              "Of a set that is not valid: the relation that it contains, with the circuit or "
              "cut-set, or what it leaves open.",
              [](const View& v) { return v.reason; })
        .only_if(is_not_valid);
    keys.text("hint", "What to remove or to add.", [](const View& v) { return v.hint; })
        .only_if(is_not_valid);
  });
  return record;
}

}  // namespace

const Record<InputsReportView>& inputs_report_record() {
  using View = InputsReportView;
  static const Record<View> record(
      "What 'kinestat inputs --format json' writes: which motions and actions determine all "
      "others.",
      [](Record<View>& keys) {
        add_head(keys);
        keys.part("inputs", sides_record(), [](const View& v) -> const View& { return v; })
            .in_tables_is(TableRole::table);
        keys.list("choices",
                  choice_record(),
                  "The verdict on the sets given with --judge, each on every side that has its "
                  "names.",
                  [](const View& v, const Each<ChoiceVerdict>& each) {
                    for (const ChoiceVerdict& choice : v.inputs.choices) {
                      each(choice);
                    }
                  })
            .not_in_tables();
        add_diagnostics(keys);
      });
  return record;
}

}  // namespace kinestat
