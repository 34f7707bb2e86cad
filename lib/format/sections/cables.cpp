// The section `cables`.
#include <fmt/format.h>

#include "format/sections/sections.hpp"
#include "forms/alternatives.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"
#include "forms/variants.hpp"

namespace kinestat {

namespace {

// Of both kinds of station, as the schema has their keys in one mapping.
constexpr const char* kStationPlace =
    "Where the cable is fixed, or the centre of the pulley, in the drawn position; default for a "
    "pulley: the point of its body's first revolute coupling, unless 'gears' places that.";

constexpr const char* kStationForms =
    "write {body: NAME, at: [x, y]} for a point, or {pulley: NAME, radius: 1, wrap: clockwise} for "
    "a pulley";

const Mapping<CableStation>& fixed_point() {
  static const Mapping<CableStation> mapping(
      "", "a point on a body", "{body: block_a, at: [0, 0]}", [](auto& m) {
        m.key("body", "The body to which the cable is fixed.")
            .needed(&CableStation::body, body_name(), "block_a");
        m.key("at", kStationPlace).needed(&CableStation::at, point());
      });
  return mapping;
}

void declare_wrap(Mapping<CableStation>& m) {
  m.key("radius", "Radius of the pulley at the cable; required unless 'points' are given.")
      .needed(&CableStation::radius, size(), "60 mm");
  m.key("wrap",
        "Direction of rotation about +z (in space about the axis) of someone who follows the cable "
        "in the order of the list; required unless 'points' are given.")
      .needed(&CableStation::wrap,
              choice_of<Wrap>({{"clockwise", "to the right"}, {"counterclockwise", "to the left"}}),
              "clockwise")
      .add_hint("'wrap: clockwise' or 'wrap: counterclockwise', seen along the cable");
  m.key("axis",
        "The pulley's axis, about which the direction of 'wrap' counts: x, y, z, -x, -y, -z or a "
        "vector [ax, ay, az]. Default: z in the plane, in space the axis of its body's first "
        "revolute coupling.")
      .may(&CableStation::axis, turning_axis(), "z");
  m.key("points",
        "The points where the cable meets and leaves the pulley, in that order, instead of radius "
        "and wrap.")
      .may(
          &CableStation::points,
          list_of(point(),
                  "",
                  "write points: [[x, y], [x, y]]: where the cable meets the pulley, then where it "
                  "leaves it",
                  {.least = 2, .most = 2}),
          "[[0, 10], [2, 10]]");
  m.rule({.kind = FormRule::Kind::spares, .key = "points", .others = {"radius", "wrap"}});
}

void declare_slip(Mapping<CableStation>& m) {
  m.key(
       "slip",
       "true if the cable may slip on the pulley: a virtual link rope_wheel on a revolute coupling "
       "of that name then holds both segments; false for a drum or a toothed wheel. Default "
       "false.")
      .may(&CableStation::slip, flag(), "true");
  m.key("turns",
        "Whole turns of the cable around the pulley in addition to the arc that is drawn, as on a "
        "capstan.")
      .may(&CableStation::turns, not_negative_whole(), "3")
      .usual("0");
  m.key("friction",
        "Coefficient of friction between cable and pulley. The report gives the limit exp(mu "
        "theta) of the tension ratio and whether the cable sticks; if a case lets it slip, the "
        "tensions have this ratio, divided by 'eta' if that is given.")
      .may(&CableStation::friction, not_negative(), "0.3")
      .usual("0");
  m.key(
       "eta",
       "Efficiency of the pulley, above 0 and at most 1: on a pulley without a torque, the tension "
       "behind is eta times that ahead, in the direction in which the cable runs relative to what "
       "it turns or slips on. One that drives its cable takes 1/eta of the torque, one that is "
       "driven gives eta times the tension ahead, less that behind.")
      .may(&CableStation::eta, efficiency(), "0.95")
      .usual("1");
}

const Mapping<CableStation>& pulley() {
  static const Mapping<CableStation> mapping(
      "",
      "a pulley that the cable wraps",
      "{pulley: wheel, radius: 1, wrap: clockwise}",
      [](auto& m) {
        m.key("pulley", "The body of the pulley that the cable wraps.")
            .needed(&CableStation::body, body_name(), "wheel")
            .selects(&CableStation::is_pulley, true);
        m.key("at", kStationPlace).may(&CableStation::at, point());
        declare_wrap(m);
        declare_slip(m);
      });
  return mapping;
}

Form<CableStation> station() {
  auto form = one_mapping_of<CableStation>(
      {&fixed_point(), &pulley()},
      {.none = "{} lacks the key 'body' or 'pulley'",
       .none_hint = kStationForms,
       .both = "{} has both 'body' and 'pulley'",
       .both_hint =
           "keep 'body' for a point where the cable is fixed, 'pulley' for one that it wraps"},
      [](const CableStation& one) { return one.is_pulley ? std::size_t{1} : std::size_t{0}; });
  form.shape.definition = "station";
  form.shape.meaning =
      "A point on a body where the cable ends or is fixed, {body, at}, or a pulley that it wraps, "
      "{pulley, radius, wrap, …}.";
  return form;
}

// A cable without ends is fixed nowhere; one with ends must not slip off them.
void check_ends(const CableDescription& cable, const FileValue& value) {
  for (const CableStation& one : cable.over) {
    const bool is_end = &one == &cable.over.front() || &one == &cable.over.back();
    if (cable.closed && !one.is_pulley) {
      value.found.error(
          "E0314",
          one.where,
          fmt::format(
              "{} is closed and cannot be fixed at a point of '{}'", value.what, one.body.text),
          "make it a pulley, or remove 'closed: true'");
    } else if (!cable.closed && is_end && one.is_pulley && one.slip) {
      value.found.error(
          "E0314",
          one.where,
          fmt::format("{} ends on pulley '{}' and would slip off it", value.what, one.body.text),
          "remove 'slip' if it is a drum, end the cable at a point {body: NAME, at: …}, or write "
          "'closed: true' for a belt");
    }
  }
}

const Mapping<CableDescription>& cable() {
  static const Mapping<CableDescription> mapping(
      "cable",
      "A cable, belt or chain. Each straight segment becomes a cable coupling, named with a "
      "number: rope_1, rope_2, …; rope_1.F is its tension. The points of contact with pulleys are "
      "calculated.",
      "{over: [{body: block_a, at: [0, 0]}, {pulley: wheel, radius: 1, wrap: clockwise, slip: "
      "true}, {body: block_b, at: [2, 0]}]}",
      [](auto& m) {
        m.key("over",
              "The stations of the cable, in order: points on bodies, and pulleys that it wraps; "
              "an open cable starts and ends at points or on drums.")
            .needed(&CableDescription::over,
                    list_of(station(), "station {0} of {1}", kStationForms, {.least = 2}),
                    "[{body: block_a, at: [0, 0]}, {pulley: wheel, radius: 1, wrap: clockwise, "
                    "slip: true}, {body: block_b, at: [2, 0]}]")
            .add_hint("'over:' and below it lines '- {body: …, at: …}' or '- {pulley: …, …}'");
        m.key("closed",
              "true joins the last station to the first: a belt or chain, over pulleys only. "
              "Default false.")
            .may(&CableDescription::closed, flag(), "true");
        m.check(check_ends);
      });
  return mapping;
}

}  // namespace

Form<std::vector<CableDescription>> cables() {
  return named(&CableDescription::name,
               cable().form(),
               {.item = "a cable", .name_definition = "new_name"},
               "cable '{0}'");
}

}  // namespace kinestat
