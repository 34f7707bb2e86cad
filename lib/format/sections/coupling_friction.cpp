// The key `friction` of a coupling.
#include <array>

#include "format/sections/coupling_values.hpp"
#include "forms/alternatives.hpp"
#include "forms/mapping.hpp"
#include "forms/number_forms.hpp"

namespace kinestat {

namespace {

// What the kinds of friction say otherwise of the same keys. A key without a text is not taken.
struct FrictionTexts {
  std::string_view definition;
  std::string_view meaning;
  std::string_view example;
  std::string_view radius;
  std::string_view thrust_radius;
  std::string_view length;
  bool has_constant;  ///< tau
};

constexpr std::string_view kCollar =
    "Mean radius of the collar, where the friction of the axial force acts.";
constexpr std::string_view kGuideLength =
    "Length of the guide of a prismatic coupling, over which its edges carry a couple.";

const FrictionTexts& texts_of(FrictionKind kind) {
  static constexpr std::array<FrictionTexts, 6> kTexts = {{
      {.definition = "journal_friction",
       .meaning =
           "Friction of a revolute coupling: a couple against its motion in the case. The "
           "coefficient needs the radius of the journal; 'thrust_radius' alone will do where "
           "'passive' lists the axial force alone.",
       .example = "{mu: 0.1, radius: 12 mm}",
       .radius =
           "Radius of the journal, where the friction of the force perpendicular to the axis acts.",
       .thrust_radius = kCollar,
       .length =
           "Length of the journal, over which its ends carry a couple perpendicular to the axis.",
       .has_constant = true},
      {.definition = "thread_friction",
       .meaning = "Friction of a helical coupling: a couple against its motion in the case. The "
                  "coefficient needs the mean radius of the thread.",
       .example = "{mu: 0.1, radius: 12 mm}",
       .radius = "Mean radius of the thread.",
       .thrust_radius = {},
       .length = {},
       .has_constant = true},
      {.definition = "guide_friction",
       .meaning = "Friction of a prismatic coupling: a force against its motion in the case. A "
                  "coefficient alone, 0.1, or a mapping.",
       .example = "{mu: 0.1, length: 80 mm}",
       .radius = "Radius of the spline or key that keeps the guide from turning, where the "
                 "friction of the torque about its axis acts.",
       .thrust_radius = {},
       .length = kGuideLength,
       .has_constant = false},
      {.definition = "sliding_friction",
       .meaning = "Friction of surfaces or teeth that slide on each other: the coefficient times "
                  "the normal force, against the sliding in the case. A coefficient alone, 0.1, or "
                  "a mapping.",
       .example = "{mu: 0.1}",
       .radius = {},
       .thrust_radius = {},
       .length = {},
       .has_constant = false},
      {.definition = "drag",
       .meaning =
           "Drag of an open clutch or brake: a couple against its slip; none if it does not slip.",
       .example = "{tau: 0.5 N*m, c: 0.01 N*m*s/rad}",
       .radius = {},
       .thrust_radius = {},
       .length = {},
       .has_constant = true},
      {.definition = "friction",
       .meaning = "Friction of the coupling: a coefficient alone, 0.1, or a mapping. It acts "
                  "against the motion of the case; of this type of coupling it is not analysed "
                  "yet.",
       .example = "{mu: 0.1, radius: 12 mm}",
       .radius = "Radius of the journal of a revolute coupling, or mean radius of the thread of a "
                 "helical one.",
       .thrust_radius = kCollar,
       .length = kGuideLength,
       .has_constant = true},
  }};
  return kTexts.at(static_cast<std::size_t>(kind));
}

bool turns(FrictionKind kind) {
  return kind == FrictionKind::journal || kind == FrictionKind::thread;
}

bool has_coefficient(FrictionKind kind) {
  return kind != FrictionKind::drag;
}

// A radius above zero is what a thread must have.
void declare_radius(Mapping<FrictionDescription>& m, FrictionKind kind) {
  m.key("radius", texts_of(kind).radius)
      .may(&FrictionDescription::radius,
           called(kind == FrictionKind::thread ? size() : non_negative_length(), "{1}"),
           kind == FrictionKind::guide ? "15 mm" : "12 mm")
      .add_hint("for example 'radius: 20 mm'");
  if (kind == FrictionKind::thread) {
    m.rule({.kind = FormRule::Kind::needed_beside, .key = "radius", .others = {"mu"}});
  } else if (kind == FrictionKind::journal) {
    m.rule({.kind = FormRule::Kind::needed_beside,
            .key = "radius",
            .others = {"mu", "thrust_radius"}});
  }
}

void declare_drag(Mapping<FrictionDescription>& m, FrictionKind kind) {
  if (kind == FrictionKind::guide) {
    m.key("c", "Viscous force per velocity, added to the friction of the load.")
        .may(&FrictionDescription::c, called(viscous_force(), "{1}"), "5 N*s/m")
        .usual("0");
  } else {
    m.key("c", "Viscous couple per angular velocity, added to the friction of the load.")
        .may(&FrictionDescription::c, called(viscous_couple(), "{1}"), "0.02 N*m*s/rad")
        .usual("0");
  }
}

void declare_friction(Mapping<FrictionDescription>& m, FrictionKind kind) {
  const FrictionTexts& texts = texts_of(kind);
  SharedList<std::string_view> coefficients;
  if (has_coefficient(kind)) {
    coefficients.push_back("mu");
    m.key("mu", "Coefficient of friction.")
        .may(&FrictionDescription::mu, called(not_negative(), "{1}"), "0.1");
    if (kind != FrictionKind::sliding && kind != FrictionKind::no_law) {
      m.key("mu_static",
            "Coefficient of static friction, which a simulation uses at rest; not less than 'mu'.")
          .may(&FrictionDescription::mu_static, called(not_negative(), "{1}"), "0.15")
          .usual("mu");
      m.rule({.kind = FormRule::Kind::needed_beside, .key = "mu", .others = {"mu_static"}});
    }
  }
  if (!texts.radius.empty()) {
    declare_radius(m, kind);
  }
  if (texts.has_constant) {
    coefficients.push_back("tau");
    m.key("tau",
          "Friction couple that does not depend on the load. It may depend on 'speed', the "
          "magnitude of the relative angular velocity.")
        .may(&FrictionDescription::tau, called(friction_moment(), "{1}"), "0.2 N*m")
        .example("0.2 N*m + 3e-6 N*m*s^2/rad^2 * speed^2")
        .usual("0");
  }
  if (!texts.thrust_radius.empty()) {
    m.key("thrust_radius", texts.thrust_radius)
        .may(&FrictionDescription::thrust_radius, called(non_negative_length(), "{1}"), "18 mm");
  }
  if (!texts.length.empty()) {
    m.key("length", texts.length)
        .may(&FrictionDescription::length,
             called(size(), "{1}"),
             kind == FrictionKind::journal ? "40 mm" : "80 mm");
  }
  if (kind != FrictionKind::sliding) {
    coefficients.push_back("c");
    declare_drag(m, kind);
  }
  m.rule({.kind = FormRule::Kind::any_of, .others = coefficients});
}

const Mapping<FrictionDescription>& friction_mapping(FrictionKind kind) {
  using Friction = Lazy<Mapping<FrictionDescription>>;
  const auto made = [](FrictionKind one) {
    return Friction([one] {
      return Mapping<FrictionDescription>(
          "", "", texts_of(one).example, [one](auto& m) { declare_friction(m, one); });
    });
  };
  static const std::array<Friction, 6> mappings = {made(FrictionKind::journal),
                                                   made(FrictionKind::thread),
                                                   made(FrictionKind::guide),
                                                   made(FrictionKind::sliding),
                                                   made(FrictionKind::drag),
                                                   made(FrictionKind::no_law)};
  return mappings.at(static_cast<std::size_t>(kind));
}

bool is_mu_alone(const FrictionDescription& one) {
  return one.mu && !one.mu_static && !one.radius && !one.thrust_radius && !one.length && !one.tau &&
         !one.c;
}

Form<FrictionDescription> mu_alone() {
  return converted<FrictionDescription>(
      not_negative(),
      [](Value mu) {
        FrictionDescription friction;
        friction.where = mu.where;
        friction.mu = std::move(mu);
        return friction;
      },
      [](const FrictionDescription& one) { return *one.mu; });
}

}  // namespace

Form<FrictionDescription> friction_of(FrictionKind kind) {
  const FrictionTexts& texts = texts_of(kind);
  auto form =
      !has_coefficient(kind) ? friction_mapping(kind).form()
      : turns(kind)
          ? only_if(
                friction_mapping(kind).form(),
                [](const YamlNode& node) { return node.kind != YamlKind::scalar; },
                "{} must be a mapping, as it needs a radius",
                "write friction: {mu: 0.1, radius: 12 mm}: of the journal, or the mean one "
                "of the thread")
          : by_shape<FrictionDescription>(
                {friction_mapping(kind).form(), mu_alone()}, [](const FrictionDescription& one) {
                  return is_mu_alone(one) ? std::size_t{1} : std::size_t{0};
                });
  form.shape.definition = texts.definition;
  form.shape.meaning = texts.meaning;
  form.shape.examples = {texts.example};
  if (has_coefficient(kind) && !turns(kind)) {
    form.shape.examples.push_back("0.1");
  }
  return form;
}

}  // namespace kinestat
