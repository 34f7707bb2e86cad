#include "studies/motion/report/motion_dynamics_record.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "studies/motion/report/actuator_record.hpp"

namespace kinestat {

namespace {

const Record<CycleSpeed>& speed_record() {
  using View = CycleSpeed;
  static const Record<View> record(
      "The speed of the flywheel while the drive supplies its mean action, including everything "
      "else that turns; null where actions depend on speed, as friction and dampers do.",
      [](Record<View>& keys) {
        keys.quantity(
            "greatest", QuantityKind::angular_velocity, "The greatest speed.", [](const View& v) {
              return v.greatest;
            });
        keys.quantity("greatest_at",
                      QuantityKind::angle,
                      "Where that is: position of the drive; of equal ones the first.",
                      [](const View& v) { return v.greatest_at; })
            .not_compared();
        keys.quantity(
            "least", QuantityKind::angular_velocity, "The least speed.", [](const View& v) {
              return v.least;
            });
        keys.quantity("least_at",
                      QuantityKind::angle,
                      "Where that is: position of the drive; of equal ones the first.",
                      [](const View& v) { return v.least_at; })
            .not_compared();
        keys.number("fluctuation",
                    Bare::number,
                    "Greatest minus least speed, over the mean speed.",
                    [](const View& v) { return v.fluctuation; });
      });
  return record;
}

const Record<FlywheelFigures>& flywheel_record() {
  using View = FlywheelFigures;
  static const Record<View> record(
      "The flywheel that keeps the speed of the cycle nearly constant.", [](Record<View>& keys) {
        using enum QuantityKind;
        keys.text(
            "at", "The actuator on whose freedom it turns.", [](const View& v) { return v.at; });
        keys.text("motor", "The actuator that drives.", [](const View& v) { return v.motor; });
        keys.number("allowed",
                    Bare::number,
                    "The required fluctuation: greatest minus least speed, over the mean.",
                    [](const View& v) { return v.fluctuation; });
        keys.quantity("speed", angular_velocity, "Mean speed of the flywheel.", [](const View& v) {
          return v.speed;
        });
        keys.quantity("mean_moment",
                      moment,
                      "Mean action of a rotating drive, which it may supply constantly.",
                      [](const View& v) { return v.mean_action; })
            .only_if([](const View& v) { return v.motor_turns; });
        keys.quantity("mean_force",
                      force,
                      "Mean action of a sliding drive, which it may supply constantly.",
                      [](const View& v) { return v.mean_action; })
            .only_if([](const View& v) { return !v.motor_turns; });
        keys.quantity("energy_fluctuation",
                      energy,
                      "The range of the energy that the drive supplies beyond its mean.",
                      [](const View& v) { return v.energy; });
        keys.quantity("inertia",
                      inertia,
                      "The required moment of inertia: that energy over the product of fluctuation "
                      "and square of the speed. The inertia that already turns is additional.",
                      [](const View& v) { return v.inertia; });
        keys.part("with_it", speed_record(), [](const View& v) { return v.with_it; });
      });
  return record;
}

struct HarmonicView {
  const HarmonicSeries& series;
  const Harmonic& harmonic;
};

const Record<HarmonicView>& harmonic_record() {
  using View = HarmonicView;
  static const Record<View> record(
      "One order: amplitude * cos(order * turn - phase).", [](Record<View>& keys) {
        const auto amplitude = [](const View& v) { return v.harmonic.amplitude; };
        keys.quantity("force", QuantityKind::force, "The amplitude of a force.", amplitude)
            .at_least(0)
            .only_if([](const View& v) { return v.series.kind == QuantityKind::force; });
        keys.quantity("moment", QuantityKind::moment, "The amplitude of a moment.", amplitude)
            .at_least(0)
            .only_if([](const View& v) { return v.series.kind == QuantityKind::moment; });
        keys.quantity("phase",
                      QuantityKind::angle,
                      "The phase, the turn being the position of the drive; null of an order that "
                      "is zero.",
                      [](const View& v) { return v.harmonic.phase; })
            .not_compared();
      });
  return record;
}

const Record<HarmonicSeries>& series_record() {
  using View = HarmonicSeries;
  static const Record<View> record("What is taken apart.", [](Record<View>& keys) {
    const auto mean = [](const View& v) { return v.mean; };
    keys.quantity("mean_force", QuantityKind::force, "The mean of a force.", mean)
        .only_if([](const View& v) { return v.kind == QuantityKind::force; });
    keys.quantity("mean_moment", QuantityKind::moment, "The mean of a moment.", mean)
        .only_if([](const View& v) { return v.kind == QuantityKind::moment; });
    keys.map("orders",
             harmonic_record(),
             "By order: the number of periods per rotation of the drive.",
             [](const View& v, const Each<HarmonicView>& each) {
               for (const Harmonic& one : v.orders) {
                 each(std::to_string(one.order), {.series = v, .harmonic = one});
               }
             });
  });
  return record;
}

struct ShakingView {
  const MotionDynamics& of;
  const ShakingForce& force;
};

// A place of the first drive, with what it measures.
std::pair<std::optional<double>, QuantityKind> place_of(const MotionDynamics& of,
                                                        const std::optional<double>& place) {
  return {place, of.place_kind()};
}

const Record<ShakingView>& shaking_record() {
  using View = ShakingView;
  static const Record<View> record("The shaking force.", [](Record<View>& keys) {
    keys.quantity("rms", QuantityKind::force, "Root mean square in time.", [](const View& v) {
      return v.force.rms;
    });
    keys.quantity("greatest", QuantityKind::force, "The greatest.", [](const View& v) {
      return v.force.greatest;
    });
    keys.by_context("greatest_at",
                    ByContext::drive,
                    "Where that is: position of the first drive; of equal ones the first.",
                    [](const View& v) { return place_of(v.of, v.force.greatest_at); })
        .not_compared();
  });
  return record;
}

struct CounterweightView {
  const MotionDynamics& of;
  const Counterweight& weight;
};

const Record<CounterweightView>& counterweight_record() {
  using View = CounterweightView;
  static const Record<View> record(
      "What a body must carry, in the drawn position.", [](Record<View>& keys) {
        keys.converted("mass_radius",
                       ByContext::beside,
                       "Mass times distance from the axis.",
                       [](const View& v) {
                         const double si = v.weight.mass_radius.norm();
                         return std::pair(std::optional(mass_radius_from_si(si, v.of.units)),
                                          mass_radius_unit(v.of.units));
                       })
            .at_least(0);
        keys.quantity("angle",
                      QuantityKind::angle,
                      "In the plane, the direction from the axis, from x; null of none.",
                      [](const View& v) {
                        const Vec3& at = v.weight.mass_radius;
                        return at.isZero(0.0) ? std::nullopt
                                              : std::optional(std::atan2(at.y(), at.x()));
                      })
            .not_compared()
            .only_if([](const View& v) { return v.of.is_planar; });
        keys.custom("along",
                    vector_shape(ByContext::beside, false),
                    "The same as a vector, along x, y, z.",
                    [](const View& v, Archive& to) {
                      to.begin_list();
                      for (const double component : v.weight.mass_radius) {
                        to.number(mass_radius_from_si(component, v.of.units),
                                  mass_radius_unit(v.of.units));
                      }
                      to.end_list();
                    });
        keys.text("unit",
                  "That of mass times distance.",
                  [](const View& v) { return mass_radius_unit(v.of.units); })
            .not_in_tables()
            .not_compared();
      });
  return record;
}

struct BalanceView {
  const MotionDynamics& of;
  const BalanceFigures& balance;
};

const Record<BalanceView>& balance_record() {
  using View = BalanceView;
  static const Record<View> record(
      "Counterweights with the least mean square shaking force in time.", [](Record<View>& keys) {
        keys.map("counterweights",
                 counterweight_record(),
                 "By body.",
                 [](const View& v, const Each<CounterweightView>& each) {
                   for (const Counterweight& one : v.balance.counterweights) {
                     each(one.body, {.of = v.of, .weight = one});
                   }
                 });
        keys.part("before", shaking_record(), "The shaking force without them.", [](const View& v) {
          return ShakingView{.of = v.of, .force = v.balance.before};
        });
        keys.part("after", shaking_record(), "The shaking force with them.", [](const View& v) {
          return ShakingView{.of = v.of, .force = v.balance.after};
        });
      });
  return record;
}

struct LimitView {
  const MotionDynamics& of;
  const LimitSpeed& limit;
};

const Record<LimitView>& limit_record() {
  using View = LimitView;
  static const Record<View> record(
      "The constant drive speed at which the force is zero somewhere in the motion; null if there "
      "is none.",
      [](Record<View>& keys) {
        const auto turns = [](const View& v) { return v.of.drive_turns; };
        const auto slides = [](const View& v) { return !v.of.drive_turns; };
        const auto speed = [](const View& v) { return v.limit.speed; };
        keys.text("coupling", "The contact or segment of a cable.", [](const View& v) {
          return v.limit.coupling;
        });
        keys.quantity("angular_velocity",
                      QuantityKind::angular_velocity,
                      "For a rotating drive; 0 if the force is not positive even at rest.",
                      speed)
            .only_if(turns);
        keys.quantity("velocity",
                      QuantityKind::velocity,
                      "For a sliding drive; 0 if the force is not positive even at rest.",
                      speed)
            .only_if(slides);
        keys.by_context("at",
                        ByContext::drive,
                        "Where that is: position of the first drive; of equal ones the first.",
                        [](const View& v) { return place_of(v.of, v.limit.at); })
            .not_compared();
      });
  return record;
}

}  // namespace

double mass_radius_from_si(double value, const FileUnits& units) {
  return units.from_si(QuantityKind::mass, units.from_si(QuantityKind::length, value));
}

std::string mass_radius_unit(const FileUnits& units) {
  return units.text(QuantityKind::mass) + "*" + units.text(QuantityKind::length);
}

const Record<MotionDynamics>& motion_dynamics_record() {
  using View = MotionDynamics;
  static const Record<View> record(
      "The results requested by the section 'dynamics'.", [](Record<View>& keys) {
        keys.map("actuators",
                 actuator_record(),
                 "What each of 'actuators' must do over the whole motion.",
                 [](const View& v, const Each<ActuatorView>& each) {
                   for (const ActuatorFigures& one : v.actuators) {
                     each(one.name, {.of = v, .actuator = one});
                   }
                 })
            .in_tables_as("actuator")
            .only_if([](const View& v) { return !v.actuators.empty(); });
        keys.part("energy", energy_record(), [](const View& v) { return *v.energy; })
            .only_if([](const View& v) { return v.energy.has_value(); });
        keys.part("flywheel", flywheel_record(), [](const View& v) { return *v.flywheel; })
            .only_if([](const View& v) { return v.flywheel.has_value(); });
        keys.map("harmonics",
                 series_record(),
                 "Actions of drives, shaking wrench and ground wrench, over the rotation of the "
                 "drive.",
                 [](const View& v, const Each<HarmonicSeries>& each) {
                   for (const HarmonicSeries& one : v.harmonics) {
                     each(one.name, one);
                   }
                 })
            .in_tables_is(TableRole::element)
            .only_if([](const View& v) { return !v.harmonics.empty(); });
        keys.part("balance",
                  balance_record(),
                  [](const View& v) { return BalanceView{.of = v, .balance = *v.balance}; })
            .only_if([](const View& v) { return v.balance.has_value(); });
        keys.map("limit_speed",
                 limit_record(),
                 "By the force that vanishes.",
                 [](const View& v, const Each<LimitView>& each) {
                   for (const LimitSpeed& one : v.limit_speeds) {
                     each(one.action, {.of = v, .limit = one});
                   }
                 })
            .only_if([](const View& v) { return !v.limit_speeds.empty(); });
      });
  return record;
}

}  // namespace kinestat
