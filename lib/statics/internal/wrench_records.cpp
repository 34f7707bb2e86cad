#include "statics/internal/wrench_records.hpp"

#include "screw/screw_record.hpp"

namespace kinestat {

namespace {

// Of a wrench that may be open.
template <class Value, class Read>
std::optional<Value> read_if_known(const CouplingWrenchView& v, const Read& read) {
  return v.wrench ? std::optional<Value>(read(*v.wrench)) : std::nullopt;
}

// About the point of its coupling.
Vec3 moment_of(const FrictionView& v) {
  const auto e = static_cast<std::size_t>(v.friction.coupling.value);
  const Vec3 at = v.geometry.points[e];
  return moment_at(written(v.friction.wrench), at).zeroed();
}

}  // namespace

const Record<CouplingWrenchView>& coupling_wrench_record() {
  using View = CouplingWrenchView;
  static const Record<View> record("Action of one coupling.", [](Record<View>& keys) {
    keys.sixfold("wrench",
                 QuantityKind::moment,
                 QuantityKind::force,
                 "Moment about the origin, then force; null where equilibrium does not determine "
                 "it.",
                 [](const View& v) {
                   return read_if_known<Sixfold>(v, [&](const BoundedWrench& wrench) {
                     return sixfold_of(about_world(wrench, v.geometry.origin).zeroed());
                   });
                 });
    keys.vector("moment",
                QuantityKind::moment,
                "Moment about the point of the coupling; null where equilibrium does not determine "
                "it.",
                [](const View& v) {
                  return read_if_known<Vec3>(v, [&](const BoundedWrench& wrench) {
                    return moment_at(wrench, v.at).zeroed();
                  });
                });
    keys.vector("force",
                QuantityKind::force,
                "Force; null where equilibrium does not determine it.",
                [](const View& v) {
                  return read_if_known<Vec3>(
                      v, [](const BoundedWrench& wrench) { return wrench.force.zeroed(); });
                });
    keys.vector("at", QuantityKind::length, "The point of the coupling.", [](const View& v) {
      return v.geometry.origin.in_world(v.at);
    });
    keys.part("screw", axis_record(), [](const View& v) {
      return v.wrench ? view_of(find_axis(*v.wrench, v.geometry.length), v.geometry.origin)
                      : std::nullopt;
    });
  });
  return record;
}

const Record<LoadView>& load_record() {
  static const Record<LoadView> record(
      "One load, on a body from outside.", [](Record<LoadView>& keys) {
        keys.text("body", "The body on which it acts.", [](const LoadView& v) {
          return v.mechanism.topology.body(v.load.acts.body).name;
        });
        keys.sixfold("wrench",
                     QuantityKind::moment,
                     QuantityKind::force,
                     "Moment about the origin, then force.",
                     [](const LoadView& v) {
                       const LocalOrigin& origin = v.mechanism.geometry.origin;
                       return sixfold_of(about_world(written(v.load.acts.wrench), origin).zeroed());
                     });
        keys.vector("moment",
                    QuantityKind::moment,
                    "Moment about the point where the force acts.",
                    [](const LoadView& v) { return couple_of(v.load); });
        keys.vector("force", QuantityKind::force, "Force.", [](const LoadView& v) {
          return v.load.acts.wrench.force;
        });
        keys.vector("at",
                    QuantityKind::length,
                    "The point where the force acts; null of a couple alone.",
                    [](const LoadView& v) {
                      return v.load.point ? std::optional(
                                                v.mechanism.geometry.origin.in_world(*v.load.point))
                                          : std::nullopt;
                    });
      });
  return record;
}

const Record<FrictionView>& friction_record() {
  static const Record<FrictionView> record(
      "The friction of one coupling: a couple or, where it slides, a drag.",
      [](Record<FrictionView>& keys) {
        const auto size = [](const FrictionView& v) { return v.friction.magnitude; };
        keys.quantity("couple", QuantityKind::moment, "Magnitude of the couple.", size)
            .at_least(0)
            .only_if([](const FrictionView& v) { return v.friction.is_couple; });
        keys.quantity("drag", QuantityKind::force, "Magnitude of the force.", size)
            .at_least(0)
            .only_if([](const FrictionView& v) { return !v.friction.is_couple; });
        keys.vector(
            "moment", QuantityKind::moment, "Moment about the point of the coupling.", moment_of);
        keys.vector("force", QuantityKind::force, "Force.", [](const FrictionView& v) {
          return v.friction.wrench.force;
        });
      });
  return record;
}

const Record<PlanetShare>& planet_record() {
  static const Record<PlanetShare> record(
      "The part of an action carried by one of these planets; 'actions' gives it for all of them "
      "together.",
      [](Record<PlanetShare>& keys) {
        keys.count("count", "Number of planets.", [](const PlanetShare& v) { return v.count; })
            .at_least(2);
        keys.by_context(
            "each",
            ByContext::action,
            "Action of one planet, in the unit of force or of moment; null if it is not "
            "determined.",
            [](const PlanetShare& v) {
              const auto one = v.all ? std::optional(*v.all / v.count) : std::nullopt;
              return std::pair(one, v.kind);
            });
        keys.by_context("most_loaded",
                        ByContext::action,
                        "The same for the most heavily loaded one, for planets with "
                        "'load_sharing'.",
                        [](const PlanetShare& v) {
                          const auto most =
                              v.all ? std::optional(*v.all * v.sharing / v.count) : std::nullopt;
                          return std::pair(most, v.kind);
                        })
            .only_if([](const PlanetShare& v) { return v.sharing > 1.0; });
      });
  return record;
}

const Record<ContactView>& contact_record() {
  static const Record<ContactView> record(
      "One contact, between the segment that arrives and the one that leaves in the order of the "
      "cable.",
      [](Record<ContactView>& keys) {
        keys.quantity("wrap",
                      QuantityKind::angle,
                      "Contact angle with full turns; null where the sense of turning is not "
                      "given.",
                      [](const ContactView& v) { return v.contact.wrap; });
        keys.quantity("before",
                      QuantityKind::force,
                      "Tension of the segment that arrives; null if it is not determined.",
                      [](const ContactView& v) { return v.state.before; });
        keys.quantity("after",
                      QuantityKind::force,
                      "Tension of the segment that leaves; null if it is not determined.",
                      [](const ContactView& v) { return v.state.after; });
        keys.number("ratio",
                    Bare::number,
                    "Larger tension over smaller; null unless both pull.",
                    [](const ContactView& v) { return v.state.ratio; });
        keys.number("limit",
                    Bare::number,
                    "exp(mu theta), the largest ratio that friction holds; null without friction.",
                    [](const ContactView& v) { return v.state.limit; });
        keys.quantity("slip_speed",
                      QuantityKind::velocity,
                      "Speed of the cable over the pulley in the order of the cable; null without "
                      "known motions.",
                      [](const ContactView& v) { return v.state.slip_speed; });
        keys.quantity("slip_power",
                      QuantityKind::power,
                      "Power of the slip, (before - after) times its speed: negative where "
                      "friction takes it.",
                      [](const ContactView& v) { return v.state.slip_power; });
        keys.word(
            "belt_state",
            words_up_to(BeltState::beyond_limit),
            "Whether friction holds the cable: within the limit, moved over the pulley by the "
            "case, or beyond the limit; unknown without friction.",
            [](const ContactView& v) { return word_of(v.state.belt_state); });
      });
  return record;
}

const Record<ConverterState>& converter_record() {
  using View = ConverterState;
  static const Record<View> record(
      "One torque converter, its couples in the sense in which its coupling counts.",
      [](Record<View>& keys) {
        const auto couple = [&](const char* key, const char* meaning, double View::*member) {
          keys.quantity(key, QuantityKind::moment, meaning, [member](const View& v) {
            return std::optional(v.*member);
          });
        };
        keys.number("speed_ratio",
                    Bare::ratio,
                    "Speed of the turbine over that of the pump, both seen from the stator; null "
                    "where the pump rests.",
                    [](const View& v) { return v.speed_ratio; });
        keys.number("torque_ratio",
                    Bare::ratio,
                    "Torque of the turbine over that of the pump.",
                    [](const View& v) { return std::optional(v.torque_ratio); });
        couple("pump_torque", "What the pump takes.", &View::pump_torque);
        couple("turbine_torque", "What the turbine gives.", &View::turbine_torque);
        couple("stator_torque",
               "What the stator adds: the difference, which its body bears.",
               &View::stator_torque);
        keys.number("efficiency",
                    Bare::efficiency,
                    "Power delivered over power supplied: speed ratio times torque ratio while the "
                    "pump drives; null where no power flows.",
                    [](const View& v) { return v.efficiency(); });
        keys.quantity("loss",
                      QuantityKind::power,
                      "Power that heats the fluid.",
                      [](const View& v) { return std::optional(v.lost); })
            .at_least(0);
      });
  return record;
}

}  // namespace kinestat
