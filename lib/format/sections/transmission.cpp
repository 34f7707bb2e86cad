#include "format/sections/transmission.hpp"

#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "forms/alternatives.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

using Wanted = TransmissionDescription;

Form<Value> set_count() {
  return number_form("sets", "A number of planetary sets, up to 4 in all.", {"2"}, kSets);
}

Form<Value> element_count() {
  return number_form(
      "elements", "A number of shift elements, up to 7 in all.", {"5"}, kShiftElements);
}

Form<Value> stationary_ratio() {
  return number_form("stationary_ratio",
                     "Ring teeth over sun teeth, above 1 and up to 10.",
                     {"2.4"},
                     kStationaryRatio);
}

// One number for what has parts, too.
template <class Counts>
Form<Counts> one_or_parts(const Form<Value>& number,
                          std::optional<Value> Counts::*member,
                          const Mapping<Counts>& parts) {
  const auto one = converted<Counts>(
      number,
      [member](Value value) {
        Counts counts;
        counts.*member = std::move(value);
        return counts;
      },
      [member](const Counts& counts) { return *(counts.*member); });
  auto form = by_shape<Counts>({one, parts.form()}, [](const Counts&) { return std::size_t{1}; });
  form.read = [read = form.read](const FileValue& value) {
    auto counts = read(value);
    if (counts) {
      counts->where = value.node.where;
    }
    return counts;
  };
  return form;
}

Form<SetCounts> wanted_sets() {
  static const Mapping<SetCounts> parts("", "", "{simple: 2, double_planet: 1}", [](auto& m) {
    m.key("simple", "Sets of sun, ring and planets on a carrier that mesh with both.")
        .may(&SetCounts::simple, set_count(), "2");
    m.key("double_planet", "Sets with planets in pairs, one of which meshes with the sun.")
        .may(&SetCounts::double_planet, set_count(), "1");
    m.rule({.kind = FormRule::Kind::any_of, .others = {"simple", "double_planet"}});
    m.check([](const SetCounts& counts, const FileValue& value) {
      if (!counts.simple && !counts.double_planet && value.node.entries.empty()) {
        value.found.error("E0303",
                          value.node.where,
                          "'sets' has neither 'simple' nor 'double_planet'",
                          "write sets: 2, or {simple: 2, double_planet: 1}");
      }
    });
  });
  auto form = one_or_parts(set_count(), &SetCounts::simple, parts);
  form.write = [write = parts.form().write](const SetCounts& counts) { return write(counts); };
  return form;
}

Form<ElementCounts> wanted_elements() {
  static const Mapping<ElementCounts> parts("", "", "{clutches: 3, brakes: 2}", [](auto& m) {
    m.key("clutches", "Elements between two turning shafts.")
        .needed(&ElementCounts::clutches, element_count(), "3");
    m.key("brakes", "Elements between a shaft and the housing.")
        .needed(&ElementCounts::brakes, element_count(), "2");
  });
  auto form = one_or_parts(element_count(), &ElementCounts::all, parts);
  form.write = [number = element_count().write,
                both = parts.form().write](const ElementCounts& counts) {
    return counts.all ? number(*counts.all) : both(counts);
  };
  return form;
}

Form<ValueRange> range_of(const Form<Value>& number,
                          std::string_view definition,
                          std::string_view example) {
  auto form = converted<ValueRange>(
      list_of(number,
              "end {0} of {1}",
              fmt::format("write [least, largest], for example {}", example),
              {2, 2}),
      [](std::vector<Value> ends) { return ValueRange{.ends = std::move(ends), .where = {}}; },
      [](const ValueRange& one) { return one.ends; });
  form.read = [read = form.read](const FileValue& value) {
    auto one = read(value);
    if (one) {
      one->where = value.node.where;
    }
    return one;
  };
  form.shape.definition = definition;
  form.shape.meaning = "The least and the largest value, both included.";
  form.shape.examples = {example};
  return form;
}

Form<ValueRange> ratio_range() {
  return range_of(above_zero(), "ratio_range", "[2.5, 3.5]");
}

Form<Value> set_teeth() {
  return number_form(
      "set_teeth", "Number of teeth, a whole number from 6 to 1000.", {"18"}, kSetTeeth);
}

Form<ValueRange> teeth_range() {
  return range_of(set_teeth(), "teeth_range", "[20, 80]");
}

const Mapping<WantedTeeth>& wanted_teeth() {
  static const Mapping<WantedTeeth> mapping(
      "", "", "{sun: [20, 80], ring: [60, 120]}", [](auto& m) {
        m.key("sun", "Of suns: the least and the largest number.")
            .needed(&WantedTeeth::sun, teeth_range(), "[20, 80]");
        m.key("ring", "Of rings.").needed(&WantedTeeth::ring, teeth_range(), "[60, 120]");
        m.key("planet", "The least number for a planet; planets in pairs are equal.")
            .may(&WantedTeeth::planet, set_teeth(), "15")
            .usual("15");
        m.key("planets", "Permitted numbers of planets, or pairs, around the sun at equal angles.")
            .may(&WantedTeeth::planets, list_of(planet_count(), "", "write [3, 4]"), "[3, 4]")
            .usual("[3, 4, 5]");
      });
  return mapping;
}

const Mapping<StationaryRange>& stationary_range() {
  static const Mapping<StationaryRange> mapping(
      "stationary_range",
      "Ratios that sets of one kind may have: any in a range, or values from a list.",
      "{from: 1.6, to: 3.2}",
      [](auto& m) {
        m.example("{values: [1.6, 2, 2.4, 2.8]}");
        m.key("from", "The least.").needed(&StationaryRange::from, stationary_ratio(), "1.6");
        m.key("to", "The largest.").needed(&StationaryRange::to, stationary_ratio(), "3.2");
        m.key("values", "Only these: the answer is then exact, and quick.")
            .may(&StationaryRange::values,
                 list_of(stationary_ratio(), "", "write {values: [1.6, 2, 2.4, 2.8]}"),
                 "[1.6, 2, 2.4, 2.8]");
        m.instead("values", {"from", "to"}, "keep one of the two ways");
      });
  return mapping;
}

const Mapping<WantedGears>& wanted_gears() {
  static const Mapping<WantedGears> mapping("", "", "{forward: 4, reverse: 1}", [](auto& m) {
    m.key("forward", "Number of forward gears, 2 to 20.")
        .needed(&WantedGears::forward,
                number_form("forward_gears", "A whole number from 2 to 20.", {"6"}, kForwardGears),
                "6");
    m.key("reverse", "Number of reverse gears.")
        .may(&WantedGears::reverse, number_form("at_most_one", "0 or 1.", {"1"}, kAtMostOne), "1")
        .usual("1");
    m.key("direct", "true requires a forward gear of ratio 1 whatever the sets are. Default false.")
        .may(&WantedGears::direct, flag(), "true");
    m.key("one_change",
          "From each forward gear to the next, one element opens and one engages; false: any may.")
        .may(&WantedGears::one_change, flag(), "true")
        .usual("true");
    m.key("reverse_change", "true requires the same from first gear to reverse. Default false.")
        .may(&WantedGears::reverse_change, flag(), "true");
  });
  return mapping;
}

const Mapping<WantedRatios>& wanted_ratios() {
  static const Mapping<WantedRatios> mapping(
      "", "", "{first: [2.5, 3.5], step: [1.3, 2]}", [](auto& m) {
        m.key("first", "Of the first gear: input speed over output speed.")
            .may(&WantedRatios::first, ratio_range(), "[2.5, 3.5]");
        m.key("last", "Of the highest gear.").may(&WantedRatios::last, ratio_range(), "[0.6, 0.8]");
        m.key("spread", "First ratio over last ratio.")
            .may(&WantedRatios::spread, ratio_range(), "[3.5, 5]");
        m.key("step", "Ratio of each forward gear over that of the next, above 1.")
            .needed(&WantedRatios::step, ratio_range(), "[1.3, 2]");
        m.key("reverse", "Magnitude of the reverse ratio.")
            .may(&WantedRatios::reverse, ratio_range(), "[1.8, 3]");
      });
  return mapping;
}

const Mapping<StationaryRatioRanges>& stationary_ratios() {
  static const Mapping<StationaryRatioRanges> mapping(
      "", "", "{simple: {from: 1.6, to: 3.2}}", [](auto& m) {
        m.key("simple", "Of simple sets.")
            .may(&StationaryRatioRanges::simple, stationary_range().form(), "{from: 1.6, to: 3.2}")
            .usual("{from: 1.5, to: 4}");
        m.key("double_planet", "Of sets with planets in pairs.")
            .may(&StationaryRatioRanges::double_planet,
                 stationary_range().form(),
                 "{values: [2, 2.4, 2.8]}")
            .usual("{from: 1.5, to: 4}");
      });
  return mapping;
}

const Mapping<TransmissionLimitsDescription>& transmission_limits() {
  using Limits = TransmissionLimitsDescription;
  static const Mapping<Limits> mapping("", "", "{element_torque: 3, shaft_speed: 3}", [](auto& m) {
    m.key("element_torque", "Largest torque of an element over that of the input.")
        .may(&Limits::element_torque, above_zero(), "3");
    m.key("element_slip", "Largest slip of an open element over the speed of the input.")
        .may(&Limits::element_slip, above_zero(), "3");
    m.key("shaft_speed", "Largest speed of a shaft over that of the input.")
        .may(&Limits::shaft_speed, above_zero(), "3");
    m.key("planet_speed",
          "Largest speed of a planet relative to its carrier over that of the input.")
        .may(&Limits::planet_speed, above_zero(), "4");
    m.key("efficiency", "Least efficiency of a gear, with 'losses'.")
        .may(&Limits::efficiency, efficiency(), "0.94");
    m.key("rotating_clutches", "Largest number of elements between two turning shafts.")
        .may(&Limits::rotating_clutches, element_count(), "3");
    m.key("hollow_shafts", "Most shafts of suns that others pass between them and the axis.")
        .may(&Limits::hollow_shafts, not_negative_whole(), "3");
  });
  return mapping;
}

const Mapping<SetLosses>& set_losses() {
  static const Mapping<SetLosses> mapping("", "", "{simple: 0.02}", [](auto& m) {
    m.key("simple", "Of simple sets.").may(&SetLosses::simple, fraction(), "0.02").usual("0.02");
    m.key("double_planet", "Of sets with planets in pairs.")
        .may(&SetLosses::double_planet, fraction(), "0.03")
        .usual("0.03");
  });
  return mapping;
}

const Mapping<StructureSlice>& structure_slice() {
  static const Mapping<StructureSlice> mapping("", "", "{from: 0, to: 99}", [](auto& m) {
    m.key("from", "The number of the first, from 0.")
        .needed(&StructureSlice::from, not_negative_whole(), "0");
    m.key("to", "The number of the last.").needed(&StructureSlice::to, not_negative_whole(), "99");
  });
  return mapping;
}

void declare_size(Mapping<Wanted>& m) {
  m.key("sets", "Number of planetary sets, up to 4: simple ones, or by kind.")
      .needed(&Wanted::sets, wanted_sets(), "2")
      .example("{simple: 2, double_planet: 1}");
  m.key("elements", "Number of shift elements, up to 7; or numbers of clutches and brakes.")
      .needed(&Wanted::elements, wanted_elements(), "5")
      .example("{clutches: 3, brakes: 2}");
  m.key("engaged", "Number of elements engaged in every gear, 1 to 4.")
      .needed(&Wanted::engaged,
              number_form("engaged", "A whole number from 1 to 4.", {"2"}, kEngagedElements),
              "2");
  m.key("free_shafts", "Number of shafts connected only to elements, 0 or 1.")
      .may(&Wanted::free_shafts, number_form("at_most_one", "0 or 1.", {"1"}, kAtMostOne), "1")
      .usual("0");
}

void declare_preference(Mapping<Wanted>& m) {
  m.key("layout", "Arrangement of the shafts; what cannot be arranged in this way is only counted.")
      .may(&Wanted::layout,
           choice_of<SectionArrangement>(
               {{"any", "they need not fit around one axis"},
                {"coaxial", "input and output shafts end on the axis"},
                {"sideways", "a gear or chain takes the drive out between sets and housing"}}),
           "coaxial")
      .usual("coaxial");
  m.key("rank", "What transmissions, ladders and stationary ratios are ranked by; also --by.")
      .may(&Wanted::rank,
           choice_of<TransmissionOrder>(
               {{kTransmissionOrders[0], "mean of the forward gears, with 'losses'"},
                {kTransmissionOrders[1],
                 "how even the steps are: the deviation of their logarithms"},
                {kTransmissionOrders[2], "the largest torque of an element"},
                {kTransmissionOrders[3], "the largest speed of a shaft"},
                {kTransmissionOrders[4],
                 "rotating clutches and hollow shafts together; of as many the efficiency"}}),
           "efficiency")
      .usual("efficiency");
  m.key("structures", "A range of all structures, by number; the report gives their total number.")
      .may(&Wanted::structures, structure_slice().form(), "{from: 0, to: 99}");
}

}  // namespace

const Mapping<TransmissionDescription>& transmission_mapping() {
  static const Mapping<Wanted> mapping(
      "transmission",
      "A planetary transmission with required gears. Torques are relative to that of the input, "
      "speeds to its speed.",
      "{sets: 2, elements: 4, engaged: 2, gears: {forward: 3}, ratios: {step: [1.3, 2]}}",
      [](auto& m) {
        declare_size(m);
        m.key("gears", "The required gears; further gears may be left over.")
            .group(&Wanted::gears, wanted_gears())
            .required()
            .example("{forward: 3, reverse: 1, direct: true}");
        m.key("ratios", "The permitted ratios, each a closed range.")
            .group(&Wanted::ratios, wanted_ratios())
            .required()
            .example("{first: [2.2, 3], step: [1.3, 2]}");
        m.key("stationary_ratio", "Ring teeth over sun teeth, for the sets of each kind.")
            .group(&Wanted::stationary_ratio, stationary_ratios())
            .example("{simple: {from: 1.6, to: 3.2}}");
        m.key("teeth",
              "Permitted numbers of teeth: stationary ratios are then those of such sets, and "
              "everything found is met by whole numbers of teeth.")
            .may(&Wanted::teeth, wanted_teeth().form(), "{sun: [20, 80], ring: [60, 120]}");
        m.key("limits", "Limits that no gear of the ladder may exceed.")
            .group(&Wanted::limits, transmission_limits())
            .example("{element_torque: 3, shaft_speed: 3}");
        m.key("losses", "The fraction of its power that a set loses with its carrier at rest.")
            .group(&Wanted::losses, set_losses())
            .example("{simple: 0.02}");
        declare_preference(m);
      });
  return mapping;
}

}  // namespace kinestat
