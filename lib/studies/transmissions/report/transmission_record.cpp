#include "studies/transmissions/report/transmission_record.hpp"

#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "report/report_keys.hpp"

namespace kinestat {

namespace {

const Record<SearchStages>& stages_record() {
  using View = SearchStages;
  static const Record<View> record("What remains at each stage.", [](Record<View>& keys) {
    keys.count("structures", "Structures of the sets that were examined.", [](const View& v) {
      return v.structures;
    });
    keys.count("layouts",
               "Of these with elements, up to roles and kinds of the sets.",
               [](const View& v) { return v.layouts; });
    keys.count("labelled_layouts", "With sun, carrier and ring of every set.", [](const View& v) {
      return v.labelled_layouts;
    });
    keys.count("not_refuted",
               "Those of which the ranges of ratios may have a ladder.",
               [](const View& v) { return v.not_refuted; });
    keys.count("with_ladder", "Those that have one.", [](const View& v) { return v.with_ladder; });
    keys.count("not_buildable",
               "Of these, as no placement of the elements can be arranged.",
               [](const View& v) { return v.not_buildable; });
    keys.count("over_limits", "Of the rest, as every ladder exceeds a limit.", [](const View& v) {
      return v.over_limits;
    });
    keys.count("undecided",
               "Neither refuted nor solved when the ranges were cut small.",
               [](const View& v) { return v.undecided; });
    keys.count("found", "Those that meet all requirements.", [](const View& v) { return v.found; });
    keys.count("layouts_found", "The same up to roles and kinds of the sets.", [](const View& v) {
      return v.layouts_found;
    });
    keys.count("points",
               "Their stationary ratios, where all are lists; else 0.",
               [](const View& v) { return v.points; });
  });
  return record;
}

const Record<SetTeeth>& teeth_record() {
  using View = SetTeeth;
  static const Record<View> record(
      "The smallest that give the stationary ratio, or nearly.", [](Record<View>& keys) {
        keys.count("sun", "Of the sun.", [](const View& v) { return v.sun; });
        keys.count("planet", "Of a planet.", [](const View& v) { return v.planet; });
        keys.count("ring", "Of the ring.", [](const View& v) { return v.ring; });
        keys.count("planets",
                   "Number of planets, or pairs of them, around the sun.",
                   [](const View& v) { return v.planets; });
      });
  return record;
}

const Record<TransmissionCheck>& transmission_check_record() {
  using View = TransmissionCheck;
  static const Record<View> record(
      "What the mechanism in these teeth does, gear by gear as 'kinestat shift' solves it, against "
      "the search with the same teeth; null where that was not asked for.",
      [](Record<View>& keys) {
        keys.number("ratio",
                    Bare::number,
                    "The largest relative difference of ratios.",
                    [](const View& v) { return v.ratio; })
            .at_least(0)
            .not_compared();
        keys.number("torque",
                    Bare::number,
                    "That of torques of elements, relative to the largest of the gear.",
                    [](const View& v) { return v.torque; })
            .at_least(0)
            .not_compared();
        keys.number("efficiency",
                    Bare::number,
                    "That of efficiencies.",
                    [](const View& v) { return v.efficiency; })
            .at_least(0)
            .not_compared();
        keys.flag(
            "agrees", "Whether this is only rounding.", [](const View& v) { return v.agrees; });
      });
  return record;
}

std::optional<std::string> transmission_file(const TransmissionVariant& v) {
  return v.file.empty() ? std::nullopt : std::optional(printable(v.file));
}

struct SetView {
  const TransmissionVariant& variant;
  std::size_t set;

  Shaft shaft(std::uint8_t place) const { return variant.sets[set][place]; }

  SetRoles roles() const { return set_roles(variant.found.roles.roles_of(static_cast<int>(set))); }
};

const Record<SetView>& set_record() {
  using View = SetView;
  static const Record<View> record("A planetary set.", [](Record<View>& keys) {
    keys.word("kind", {"simple", "double_planet"}, "Its kind.", [](const View& v) {
      return v.variant.found.roles.kind_of(static_cast<int>(v.set)) == SetKind::simple
                 ? "simple"
                 : "double_planet";
    });
    keys.text("sun", "The shaft of its sun.", [](const View& v) {
      return shaft_name(v.shaft(v.roles().sun));
    });
    keys.text("carrier", "That of its carrier.", [](const View& v) {
      return shaft_name(v.shaft(v.roles().carrier));
    });
    keys.text("ring", "That of its ring.", [](const View& v) {
      return shaft_name(v.shaft(v.roles().ring));
    });
    keys.number("stationary_ratio", Bare::ratio, "Ring teeth over sun teeth.", [](const View& v) {
      return v.variant.found.stationary_ratios[v.set];
    });
    keys.part("teeth", teeth_record(), [](const View& v) -> const SetTeeth& {
      return v.variant.teeth[v.set];
    });
  });
  return record;
}

const Record<ShaftPair>& element_record() {
  using View = ShaftPair;
  static const Record<View> record("A shift element.", [](Record<View>& keys) {
    keys.word("type", {"brake", "clutch"}, "A brake holds to the housing.", [](const View& v) {
      return v[0] == kHousing ? "brake" : "clutch";
    });
    keys.text("tail", "Its first shaft.", [](const View& v) { return shaft_name(v[0]); });
    keys.text("head", "Its second shaft.", [](const View& v) { return shaft_name(v[1]); });
  });
  return record;
}

const Record<LadderGear>& listed_gear_record() {
  using View = LadderGear;
  static const Record<View> record("A gear.", [](Record<View>& keys) {
    keys.text("engaged", "The letters of its elements.", [](const View& v) {
      return engaged_letters(v.engaged);
    });
    keys.number("ratio", Bare::ratio, "Input speed over output speed.", [](const View& v) {
      return v.figures.ratio;
    });
    keys.number("efficiency", Bare::ratio, "With the losses of the sets.", [](const View& v) {
      return v.efficiency;
    });
    keys.numbers("torques",
                 Bare::ratio,
                 "Of engaged elements, tail on head, over the torque of the input.",
                 [](const View& v, const EachNumber& each) {
                   for (std::size_t j = 0; j < v.figures.torques.size(); ++j) {
                     if ((v.engaged >> j & 1U) != 0) {
                       each(element_letter(j), v.figures.torques[j], QuantityKind::dimensionless);
                     }
                   }
                 })
        .in_tables_is(TableRole::element);
    keys.numbers("slips",
                 Bare::ratio,
                 "Of open elements, head relative to tail, over the speed of the input.",
                 [](const View& v, const EachNumber& each) {
                   for (std::size_t j = 0; j < v.figures.slips.size(); ++j) {
                     if ((v.engaged >> j & 1U) == 0) {
                       each(element_letter(j), v.figures.slips[j], QuantityKind::dimensionless);
                     }
                   }
                 })
        .in_tables_is(TableRole::element);
    keys.numbers("speeds",
                 Bare::ratio,
                 "Of the turning shafts, over the speed of the input.",
                 [](const View& v, const EachNumber& each) {
                   for (std::size_t s = 1; s < v.figures.speeds.size(); ++s) {
                     each(shaft_name(static_cast<Shaft>(s)),
                          v.figures.speeds[s],
                          QuantityKind::dimensionless);
                   }
                 })
        .in_tables_is(TableRole::element);
    keys.numbers(
            "planet_speeds",
            Bare::ratio,
            "Of planets relative to their carriers, by set, over the speed of the input; of pairs "
            "those that mesh with the sun.",
            [](const View& v, const EachNumber& each) {
              for (std::size_t s = 0; s < v.planet_speeds.size(); ++s) {
                each(fmt::format("{}", s + 1), v.planet_speeds[s], QuantityKind::dimensionless);
              }
            })
        .in_tables_is(TableRole::element);
  });
  return record;
}

const Record<LadderFigures>& ladder_figures_record() {
  using View = LadderFigures;
  static const Record<View> record(
      "What its ladder requires; torques and speeds are relative to those of the input.",
      [](Record<View>& keys) {
        keys.number(
            "spread", Bare::ratio, "First ratio by last.", [](const View& v) { return v.spread; });
        keys.number("mean_efficiency", Bare::ratio, "Of the forward gears.", [](const View& v) {
          return v.mean_efficiency;
        });
        keys.number("least_efficiency", Bare::ratio, "Of all gears.", [](const View& v) {
          return v.least_efficiency;
        });
        keys.number("unevenness",
                    Bare::number,
                    "Root mean square deviation of the logarithms of the steps from their mean.",
                    [](const View& v) { return v.unevenness; })
            .at_least(0);
        keys.number("element_torque",
                    Bare::ratio,
                    "The largest of an element in any gear.",
                    [](const View& v) { return v.element_torque; });
        keys.number("element_slip",
                    Bare::ratio,
                    "The largest of an open element in any gear.",
                    [](const View& v) { return v.element_slip; });
        keys.number(
            "shaft_speed", Bare::ratio, "The largest of a shaft in any gear.", [](const View& v) {
              return v.shaft_speed;
            });
        keys.number("planet_speed",
                    Bare::ratio,
                    "The largest of a planet relative to its carrier in any gear.",
                    [](const View& v) { return v.planet_speed; });
        keys.count("rotating_clutches", "Elements between two turning shafts.", [](const View& v) {
          return v.rotating_clutches;
        });
        keys.count("hollow_shafts",
                   "Shafts of suns that another shaft passes between them and the axis, in the "
                   "section in which they are fewest; null where 'layout' is any.",
                   [](const View& v) { return v.hollow_shafts; });
      });
  return record;
}

const Record<TransmissionVariant>& variant_record() {
  using View = TransmissionVariant;
  static const Record<View> record("A transmission.", [](Record<View>& keys) {
    keys.count("structure", "The number of its structure.", [](const View& v) {
      return v.found.structure;
    });
    keys.count("layout",
               "The number of its layout among those of the structure for this task.",
               [](const View& v) { return v.found.layout; });
    keys.number("rank", Bare::number, "The ranking value; less is better.", [](const View& v) {
      return v.found.rank;
    });
    keys.count("points",
               "Stationary ratios of the lists that would suffice; 0 with ranges.",
               [](const View& v) { return v.found.points; });
    keys.count("placements",
               "Placements of its elements that can be arranged as required.",
               [](const View& v) { return v.found.placements; });
    keys.map("sets",
             set_record(),
             "Its sets by their number, from 1.",
             [](const View& v, const Each<SetView>& each) {
               for (std::size_t s = 0; s < v.sets.size(); ++s) {
                 each(fmt::format("{}", s + 1), {.variant = v, .set = s});
               }
             });
    keys.map("elements",
             element_record(),
             "Its elements by their letters.",
             [](const View& v, const Each<ShaftPair>& each) {
               for (std::size_t j = 0; j < v.found.elements.size(); ++j) {
                 each(element_letter(j), v.found.elements[j]);
               }
             });
    keys.part("figures", ladder_figures_record(), [](const View& v) -> const LadderFigures& {
      return v.found.figures;
    });
    keys.map("gears",
             listed_gear_record(),
             "The gears of its ladder by their labels.",
             [](const View& v, const Each<LadderGear>& each) {
               for (const LadderGear& gear : v.gears) {
                 each(gear.label, gear);
               }
             });
    keys.part("verification", transmission_check_record(), [](const View& v) { return v.check; })
        .in_tables_is(TableRole::element);
    keys.text(
            "file", "The mechanism file written for it; null if there is none.", transmission_file)
        .not_compared()
        .not_in_tables();
  });
  return record;
}

const Record<LadderGroup>& group_record() {
  using View = LadderGroup;
  static const Record<View> record(
      "Transmissions with one ladder of ratios.", [](Record<View>& keys) {
        keys.map("variants",
                 variant_record(),
                 "By their number, the best first.",
                 [](const View& v, const Each<TransmissionVariant>& each) {
                   for (std::size_t i = 0; i < v.variants.size(); ++i) {
                     each(fmt::format("{}", i), v.variants[i]);
                   }
                 })
            .in_tables_is(TableRole::cases);
      });
  return record;
}

const Record<TransmissionAnalysis>& transmissions_record() {
  using View = TransmissionAnalysis;
  static const Record<View> record("What was found.", [](Record<View>& keys) {
    keys.count("structure_count",
               "Total number of structures, including those outside a slice.",
               [](const View& v) { return v.structure_count; });
    keys.part("stages",
              stages_record(),
              [](const View& v) -> const SearchStages& { return v.stages; })
        .in_tables_is(TableRole::element);
    keys.count("ladder_count",
               "Different ladders of ratios; the best of them are listed.",
               [](const View& v) { return v.ladder_count; });
    keys.map("groups",
             group_record(),
             "By the number of their ladder, the best first.",
             [](const View& v, const Each<LadderGroup>& each) {
               for (std::size_t i = 0; i < v.groups.size(); ++i) {
                 each(fmt::format("{}", i), v.groups[i]);
               }
             })
        .in_tables_is(TableRole::cases);
  });
  return record;
}

}  // namespace

const Record<TransmissionReportView>& transmission_report_record() {
  using View = TransmissionReportView;
  static const Record<View> record(
      "What 'kinestat synthesize --format json' writes of a task with 'transmission'.",
      [](Record<View>& keys) {
        add_head(keys);
        keys.part("transmissions",
                  transmissions_record(),
                  [](const View& v) -> const TransmissionAnalysis& { return v.analysis; })
            .in_tables_is(TableRole::table);
        add_diagnostics(keys);
      });
  return record;
}

}  // namespace kinestat
