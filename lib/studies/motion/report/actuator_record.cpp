#include "studies/motion/report/actuator_record.hpp"

#include <string>
#include <utility>

namespace kinestat {

namespace {

bool does_turn(const ActuatorView& v) {
  return v.actuator.turns;
}

bool does_slide(const ActuatorView& v) {
  return !v.actuator.turns;
}

// One key of an actuator that turns, and one of one that slides: moment and force, say.
struct ByFreedom {
  std::string turning;
  QuantityKind turning_kind;
  std::string sliding;
  QuantityKind sliding_kind;
};

template <class Get>
void add_by_freedom(Record<ActuatorView>& keys,
                    const ByFreedom& by,
                    const std::string& what,
                    Get get) {
  keys.quantity(by.turning, by.turning_kind, what, get).only_if(does_turn);
  keys.quantity(by.sliding, by.sliding_kind, what, get).only_if(does_slide);
}

void add_place(Record<ActuatorView>& keys, std::string key, PlacedValue ActuatorFigures::*value) {
  keys.by_context(std::move(key),
                  ByContext::drive,
                  "Where that is: position of the first drive; of equal peaks the first.",
                  [value](const ActuatorView& v) {
                    return std::pair(std::optional((v.actuator.*value).at), v.of.place_kind());
                  })
      .not_compared();
}

void add_action(Record<ActuatorView>& keys) {
  const auto named = [](const std::string& what) {
    return ByFreedom{.turning = what + "_moment",
                     .turning_kind = QuantityKind::moment,
                     .sliding = what + "_force",
                     .sliding_kind = QuantityKind::force};
  };
  add_by_freedom(keys,
                 named("peak"),
                 "Its action of the largest magnitude, with its sign.",
                 [](const ActuatorView& v) { return v.actuator.peak.value; });
  add_place(keys, "peak_at", &ActuatorFigures::peak);
  add_by_freedom(keys, named("mean"), "Mean of its action in time.", [](const ActuatorView& v) {
    return v.actuator.mean;
  });
  add_by_freedom(keys,
                 named("rms"),
                 "Root mean square of its action in time, which determines the heating of a motor.",
                 [](const ActuatorView& v) { return v.actuator.rms; });
}

void add_power(Record<ActuatorView>& keys) {
  using enum QuantityKind;
  add_by_freedom(keys,
                 {.turning = "peak_angular_velocity",
                  .turning_kind = angular_velocity,
                  .sliding = "peak_velocity",
                  .sliding_kind = velocity},
                 "Its speed of the largest magnitude, with its sign.",
                 [](const ActuatorView& v) { return v.actuator.peak_speed.value; });
  keys.quantity("peak_power",
                power,
                "Its power of the largest magnitude, positive where it drives.",
                [](const ActuatorView& v) { return v.actuator.peak_power.value; });
  add_place(keys, "peak_power_at", &ActuatorFigures::peak_power);
  keys.quantity("mean_power", power, "Mean of its power in time.", [](const ActuatorView& v) {
    return v.actuator.mean_power;
  });
  keys.quantity("energy_in",
                energy,
                "Energy that it supplies while it drives.",
                [](const ActuatorView& v) { return v.actuator.energy_in; })
      .at_least(0);
  keys.quantity("energy_out",
                energy,
                "Energy that it absorbs while it brakes.",
                [](const ActuatorView& v) { return v.actuator.energy_out; })
      .at_least(0);
}

}  // namespace

const Record<ActuatorView>& actuator_record() {
  static const Record<ActuatorView> record("What an actuator must do over the whole motion.",
                                           [](Record<ActuatorView>& keys) {
                                             add_action(keys);
                                             add_power(keys);
                                           });
  return record;
}

const Record<EnergyFigures>& energy_record() {
  using Figures = EnergyFigures;
  static const Record<Figures> record(
      "Where the energy of the whole motion comes from and goes.", [](Record<Figures>& keys) {
        using enum QuantityKind;
        keys.quantity(
            "actuators", energy, "Energy supplied by all actuators.", [](const Figures& v) {
              return v.actuators;
            });
        keys.quantity("loads",
                      energy,
                      "Energy supplied by loads, weights and springs.",
                      [](const Figures& v) { return v.loads; });
        keys.quantity(
            "lost", energy, "What friction and the losses of meshes take.", [](const Figures& v) {
              return v.lost;
            });
        keys.quantity("kinetic_energy_change",
                      energy,
                      "Kinetic energy at the end minus that at the start.",
                      [](const Figures& v) { return v.kinetic_change; });
        keys.quantity("greatest_kinetic_energy",
                      energy,
                      "The greatest during the motion.",
                      [](const Figures& v) { return v.greatest_kinetic; })
            .at_least(0);
        keys.number("efficiency",
                    Bare::efficiency,
                    "Energy delivered at the outputs over energy supplied at the inputs; null "
                    "where the case does not name both, or others supply or store energy.",
                    [](const Figures& v) { return v.efficiency; });
        keys.number("audit",
                    Bare::number,
                    "Difference between the change of the kinetic energy, which follows from "
                    "velocities alone, and the integral of all powers, as a fraction of the "
                    "greatest; null where nothing with inertia moves.",
                    [](const Figures& v) { return v.audit; })
            .at_least(0)
            .not_in_tables()
            .not_compared();
      });
  return record;
}

}  // namespace kinestat
