// The section `couplings`: which keys there are; which kind takes which is said in lib/couplings.
#include <algorithm>
#include <array>
#include <memory>

#include "couplings/kinds.hpp"
#include "format/sections/coupling_values.hpp"
#include "format/sections/sections.hpp"
#include "forms/alternatives.hpp"
#include "forms/number_forms.hpp"
#include "forms/value_forms.hpp"
#include "forms/worded.hpp"

namespace kinestat {

namespace {

using Coupling = CouplingDescription;
using Key = Mapping<Coupling>::Key;

struct KeyRow {
  CouplingKey key;
  std::string_view word;
  std::string_view meaning;  ///< unless a kind says another
  void (*declare)(Key key);
};

template <class T>
Form<T> direction_of(Form<T> form) {
  return called(std::move(form), "the direction of {0}");
}

constexpr auto kRows = std::to_array<KeyRow>({
    {CouplingKey::at,
     "at",
     "",
     [](Key key) {
       key.may(
           &Coupling::at, [] { return called(coupling_point(), "the point of {0}"); }, "[6, 5]");
     }},
    {CouplingKey::turning_axis,
     "axis",
     "The axis about which the coupling turns: x, y, z, -x, -y, -z or a vector [ax, ay, az] of any "
     "length but zero. In the plane it is z, which need not be written. A positive keyword names "
     "the freedom (wz), -z or a vector leaves it plain (w).",
     [](Key key) {
       key.may(
           &Coupling::axis, [] { return called(turning_axis(), "the axis of {0}"); }, "z");
     }},
    {CouplingKey::sliding_axis,
     "axis",
     "The direction of sliding: x, y, z, -x, -y, -z or a vector, [ax, ay] in the plane, [ax, ay, "
     "az] in space. A positive keyword names the freedom (vx), -x or a vector leaves it plain (v).",
     [](Key key) {
       key.may(
           &Coupling::axis, [] { return called(direction(), "the axis of {0}"); }, "x");
     }},
    {CouplingKey::axes,
     "axes",
     "The two axes of a universal coupling: the first is fixed in the tail, the second in the "
     "head.",
     [](Key key) {
       const auto two = list_of(called(direction(), "the axes of {0}"), "", "", {2, 2});
       key.may(&Coupling::axes,
               called(only_if(two,
                              is_pair,
                              "{} must be two axes",
                              "write axes: [x, z]: the first fixed in the tail, the second in the "
                              "head"),
                      "the axes of {0}"),
               "[x, z]");
     }},
    {CouplingKey::normal,
     "normal",
     "The normal of the plane or of the contact; its force on the head is positive along it.",
     [](Key key) {
       key.may(
           &Coupling::normal, [] { return direction_of(direction()); }, "y");
     }},
    {CouplingKey::line,
     "line",
     "The direction of the line of contact, perpendicular to the normal.",
     [](Key key) {
       key.may(
           &Coupling::line, [] { return direction_of(direction()); }, "x");
     }},
    {CouplingKey::radii,
     "radii",
     "The radii of curvature of tail and head at the contact, for motions: flat for a plane, "
     "negative if concave. The normal then points from the tail into the head.",
     [](Key key) {
       key.may(
           &Coupling::radii,
           [] { return called(contact_radii(), "the radii of {0}"); },
           "[31, flat]");
     }},
    {CouplingKey::slot,
     "slot",
     "The direction of the slot in the head, along which the pin of the tail slides.",
     [](Key key) {
       key.may(
           &Coupling::slot, [] { return direction_of(direction()); }, "x");
     }},
    {CouplingKey::pitch,
     "pitch",
     "Advance per radian, right-handed if positive; or give 'lead'.",
     [](Key key) { key.may(&Coupling::pitch, called(pitch(), "the pitch of {0}"), "0.8 mm/rad"); }},
    {CouplingKey::lead,
     "lead",
     "Advance per turn, right-handed if positive; or give 'pitch'.",
     [](Key key) { key.may(&Coupling::lead, called(lead(), "the lead of {0}"), "5 mm"); }},
    {CouplingKey::tangent,
     "tangent",
     "The direction t of the tangential force of the tail on the head. With the pressure angle it "
     "gives the line of action cos(alpha) t + sin(alpha) (axis x t). Required unless "
     "'line_of_action' is given or 'gears' derives it.",
     [](Key key) {
       key.may(
           &Coupling::tangent, [] { return direction_of(direction()); }, "x");
     }},
    {CouplingKey::pressure_angle,
     "pressure_angle",
     "Pressure angle of the teeth in the transverse plane; required with 'tangent'.",
     [](Key key) { key.may(&Coupling::pressure_angle, called(angle(), "{0}"), "20 deg"); }},
    {CouplingKey::helix_angle,
     "helix_angle",
     "Helix angle of the teeth, positive if the tail is right-handed. Axis x tangent then points "
     "from the axis of the tail to the teeth.",
     [](Key key) { key.may(&Coupling::helix_angle, called(angle(), "{0}"), "15 deg").usual("0"); }},
    {CouplingKey::internal,
     "internal",
     "true if one of the two gears is a ring, which loses less power and turns in the same "
     "direction. Default false.",
     [](Key key) { key.may(&Coupling::internal, called(flag(), "'{1}'"), "true"); }},
    {CouplingKey::contact,
     "contact",
     "true models the contact of the teeth (5 freedoms, 1 constraint in space) instead of pitch "
     "circles rolling on each other. Default false.",
     [](Key key) { key.may(&Coupling::contact, called(flag(), "'{1}'"), "true"); }},
    {CouplingKey::line_of_action,
     "line_of_action",
     "The direction of the force of the tail on the head.",
     [](Key key) {
       key.may(
           &Coupling::line_of_action, [] { return direction_of(direction()); }, "x");
     }},
    {CouplingKey::screw,
     "screw",
     "The relative motion of head and tail as a screw, instead of 'axis'.",
     [](Key key) {
       key.may(&Coupling::screw,
               [] { return called(motion_screw(), "the relative screw of {0}"); });
     }},
    {CouplingKey::flank,
     "flank",
     "Which flank carries the load. With the other one the line of action is mirrored in the "
     "common "
     "pitch plane at 'at', which follows from the tangent, or from the axes about which revolutes, "
     "clutches and the like let the two bodies turn, or the guide of a rack.",
     [](Key key) {
       key.may(
              &Coupling::flank,
              [] { return called(flank_of_teeth(), "the flank of {0}"); },
              "fixed")
           .usual("loaded");
     }},
    {CouplingKey::from,
     "from",
     "Where the cable leaves the tail, in the drawn position.",
     [](Key key) { key.may(&Coupling::from, [] { return called(point(), "the end of {0}"); }); }},
    {CouplingKey::to,
     "to",
     "Where the cable ends on the head, in the drawn position.",
     [](Key key) { key.may(&Coupling::to, [] { return called(point(), "the end of {0}"); }); }},
    {CouplingKey::freedoms,
     "freedoms",
     "The freedoms of the head relative to the tail, as screws: rotations and translations. They "
     "are named as in other types: wz and vx if a keyword gives the axis, w and v along a vector; "
     "several of the same name are numbered, w1 and w2.",
     [](Key key) {
       key.may(
           &Coupling::freedoms,
           [] { return called(motion_screws(), "{0}"); },
           "[{rotation: z, at: [0, 0, 0]}]");
     }},
    {CouplingKey::constraints,
     "constraints",
     "The actions that the coupling transmits, as screws: forces and couples. Default: everything "
     "that does no work on the freedoms.",
     [](Key key) {
       key.may(
           &Coupling::constraints,
           [] { return called(action_screws(), "{0}"); },
           "[{force: y, at: [0, 0, 0]}]");
     }},
    {CouplingKey::one_way,
     "one_way",
     "Makes the clutch or brake a freewheel, which engages when its torque (of the tail on the "
     "head) has this sign.",
     [](Key key) {
       const auto sign = choice_of<OneWay>({{"+", "engages while its torque is positive"},
                                            {"-", "engages while its torque is negative"}});
       key.may(&Coupling::one_way, called(sign, "'one_way' of {0}"), "+");
     }},
    {CouplingKey::stator,
     "stator",
     "The body that supports the stator of a torque converter through its freewheel, usually the "
     "housing. The stator becomes a coupling of its own, NAME_stator. Without this key it is a "
     "fluid coupling.",
     [](Key key) {
       key.may(
           &Coupling::stator, [] { return called(body_name(), "the stator of {0}"); }, "housing");
     }},
    {CouplingKey::characteristic,
     "characteristic",
     "Characteristic of the torque converter over its speed ratio.",
     [](Key key) {
       key.needed(&Coupling::characteristic,
                  called(characteristic(), "the characteristic of {0}"),
                  "{pump_speed: 2000 rpm, pump_torque: 150 N*m, torque_ratio: 2 - speed_ratio}");
     }},
});

SharedList<Word> type_words() {
  SharedList<Word> words;
  for (const CouplingKind* kind : coupling_kinds()) {
    words.push_back({.text = kind->word, .meaning = kind->meaning});
  }
  return words;
}

// The word that has chosen the mapping.
Form<CouplingType> type_word(CouplingType type) {
  return {.shape = {.kind = FormKind::word, .words = type_words()},
          .read = [type](const FileValue&) { return std::optional(type); },
          .write = [](CouplingType one) { return single_text(std::string(word_of(one))); }};
}

void declare_head(Mapping<Coupling>& m, const CouplingKind& kind) {
  m.key("type", "The type of the coupling; it determines which other keys are allowed.")
      .needed(&Coupling::type, type_word(kind.type), "revolute")
      .add_hint("for example 'type: revolute'");
  m.key("bodies",
        "The two bodies that the coupling joins, [tail, head]: the ground or bodies of the section "
        "'bodies'. Motions are those of the head relative to the tail.")
      .pair(&Coupling::tail, &Coupling::head, coupling_ends(), "[frame, crank]")
      .add_hint("'bodies: [NAME, NAME, …]'; of a coupling 'bodies: [TAIL, HEAD]'");
}

void declare_own_keys(Mapping<Coupling>& m, const CouplingKind& kind) {
  for (const KeyRow& row : kRows) {
    const auto own = std::ranges::find(kind.keys, row.key, &KindKey::key);
    if (own != kind.keys.end()) {
      row.declare(m.key(row.word, own->meaning.empty() ? row.meaning : own->meaning));
    }
  }
}

void declare_common_keys(Mapping<Coupling>& m, const CouplingKind& kind) {
  m.key("passive", "The actions of its type that the coupling keeps; [] keeps none. Default: all.")
      .may(
          &Coupling::passive,
          [] {
            return one_or_more(called(name_of("one of its actions"), "the constraint of {0}"));
          },
          "[Rx, Ry, Rz]");
  if (kind.friction != FrictionKind::fluid) {
    m.key("friction", "").may(&Coupling::friction, [friction = kind.friction] {
      return called(friction_of(friction), "the friction of {0}");
    });
  }
  m.key("stiffness",
        "Stiffness of the actions that the coupling transmits, used by 'statics: {indeterminate: "
        "stiffness}'. Actions not named are rigid.")
      .may(
          &Coupling::stiffness,
          [] { return called(stiffness_of_actions(), "the stiffness of {0}"); },
          "{Rx: 2e6 N/m}")
      .example("{Rx: 2e6 N/m, Tz: 300 N*m/rad}");
  if (std::ranges::find(kind.keys, CouplingKey::screw, &KindKey::key) != kind.keys.end()) {
    m.instead("screw", {"axis"}, "remove 'axis': the screw has a direction of its own");
  }
  if (kind.friction == FrictionKind::guide) {
    m.rule({.kind = FormRule::Kind::needed_by_part,
            .key = "at",
            .others = {"friction", "length", "radius"}});
  }
}

Mapping<Coupling> mapping_of(const CouplingKind& kind) {
  return Mapping<Coupling>("", kind.meaning, kind.example, [&kind](auto& m) {
    declare_head(m, kind);
    declare_own_keys(m, kind);
    declare_common_keys(m, kind);
  });
}

Form<Coupling> coupling() {
  std::vector<Lazy<Mapping<Coupling>>> of_kinds;
  for (const CouplingKind* kind : coupling_kinds()) {
    of_kinds.emplace_back([kind] { return mapping_of(*kind); });
  }
  auto form = chosen_by_word<Coupling>(
      of_kinds, type_words(), "the type of a coupling", [](const Coupling& one) {
        return static_cast<std::size_t>(one.type);
      });
  form.shape.definition = "coupling";
  form.shape.meaning =
      "A coupling joins two bodies. Motions are those of the head relative to the tail, actions "
      "those of the tail on the head. The type determines which other keys are allowed.";
  form.shape.examples = {"{type: revolute, bodies: [frame, crank], at: [0, 0]}"};
  return form;
}

// Cables and gears add couplings, and gears the place of those that say none.
std::vector<Coupling> without_what_others_make(const std::vector<Coupling>& all) {
  std::vector<Coupling> own;
  for (const Coupling& one : all) {
    if (one.part == nullptr && !one.is_mesh() && one.stator_of.empty()) {
      own.push_back(one);
      const bool is_placed_by_gears = one.at && one.at->is_on_gear_axis() && !one.at->along_axis;
      own.back().at = is_placed_by_gears ? std::nullopt : one.at;
    }
  }
  return own;
}

}  // namespace

Form<std::vector<CouplingDescription>> couplings() {
  auto form = named(&Coupling::name,
                    coupling(),
                    {.item = "a coupling", .name_definition = "new_name"},
                    "coupling '{0}'");
  form.write = [write = form.write](const std::vector<Coupling>& all) {
    return write(without_what_others_make(all));
  };
  return form;
}

}  // namespace kinestat
