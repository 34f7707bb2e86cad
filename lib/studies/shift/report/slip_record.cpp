#include "studies/shift/report/slip_record.hpp"

#include "studies/shift/report/shift_parts.hpp"

namespace kinestat {

namespace {

const std::string& state_name(const SlipView& v, int state) {
  return v.analysis.shift->solution.states[static_cast<std::size_t>(state)].name;
}

const Record<SlipShaft>& shaft_record() {
  static const Record<SlipShaft> record(
      "A shaft while the element slips.", [](Record<SlipShaft>& keys) {
        using enum QuantityKind;
        keys.quantity("speed_at_start",
                      angular_velocity,
                      "Its speed where the slip begins.",
                      [](const SlipShaft& v) { return v.start; });
        keys.quantity("speed_at_end",
                      angular_velocity,
                      "Its speed where the slip has ended; null where it never does.",
                      [](const SlipShaft& v) { return v.end; });
        keys.quantity("angular_acceleration",
                      QuantityKind::angular_acceleration,
                      "Constant throughout.",
                      [](const SlipShaft& v) { return v.acceleration; });
      });
  return record;
}

void add_slip(Record<SlipView>& keys) {
  using enum QuantityKind;
  keys.quantity("slip",
                angular_velocity,
                "Head less tail of the element where the slip begins.",
                [](const SlipView& v) { return v.slip.slip; });
  keys.quantity("slip_rate",
                angular_acceleration,
                "The constant rate of change of the slip.",
                [](const SlipView& v) { return v.slip.slip_rate; });
  keys.quantity(
      "capacity", moment, "Torque of the slipping element, a magnitude.", [](const SlipView& v) {
        return v.slip.capacity;
      });
  keys.quantity("least_capacity",
                moment,
                "The capacity above which the slip ends.",
                [](const SlipView& v) { return v.slip.least_capacity; })
      .at_least(0);
  keys.quantity("holding_torque",
                moment,
                "Torque of tail on head that the element carries once engaged, under the same "
                "torques; if its magnitude exceeds the capacity, the slip continues in the other "
                "direction.",
                [](const SlipView& v) { return v.slip.holding_torque; });
}

void add_energies(Record<SlipView>& keys) {
  using enum QuantityKind;
  keys.quantity("time",
                QuantityKind::time,
                "Until the slip has ended; null where it never does.",
                [](const SlipView& v) { return v.slip.time; });
  keys.quantity("energy",
                QuantityKind::energy,
                "Lost in the element until then; null likewise.",
                [](const SlipView& v) { return v.slip.energy; });
  keys.quantity(
      "peak_power", power, "Lost in the element where the slip begins.", [](const SlipView& v) {
        return v.slip.peak_power;
      });
  keys.quantity("work",
                QuantityKind::energy,
                "Of the torques of input and output, and of loads, until then; null likewise.",
                [](const SlipView& v) { return v.slip.work; });
  keys.quantity("kinetic_energy_change",
                QuantityKind::energy,
                "Of all bodies until then, which is the work minus the energy lost; null likewise.",
                [](const SlipView& v) { return v.slip.kinetic_energy_change; });
  keys.number("residual",
              Bare::number,
              "Residual of this balance, relative to the largest of these energies: rounding.",
              [](const SlipView& v) { return v.slip.residual; })
      .at_least(0)
      .not_in_tables()
      .not_compared();
}

void add_train(Record<SlipView>& keys) {
  using enum QuantityKind;
  keys.part("input", shaft_record(), "The input.", [](const SlipView& v) -> const SlipShaft& {
    return v.slip.input;
  });
  keys.part("output", shaft_record(), "The output.", [](const SlipView& v) -> const SlipShaft& {
    return v.slip.output;
  });
  keys.quantity("input_inertia",
                inertia,
                "Of the whole transmission at the input while the output rests, as an entry of the "
                "matrix of both.",
                [](const SlipView& v) { return v.slip.input_inertia; });
  keys.quantity("output_inertia",
                inertia,
                "Likewise at the output; null where the output follows from the input.",
                [](const SlipView& v) { return v.slip.output_inertia; });
  keys.quantity(
      "shared_inertia", inertia, "The entry between them; null likewise.", [](const SlipView& v) {
        return v.slip.shared_inertia;
      });
  keys.numbers("held",
               moment,
               "Torque of tail on head of each element that stays engaged.",
               [](const SlipView& v, const EachNumber& each) {
                 for (const HeldElement& one : v.slip.held) {
                   each(name_of_element(v.analysis, one.element), one.torque, moment);
                 }
               });
}

}  // namespace

const Record<SlipView>& slip_record() {
  using View = SlipView;
  static const Record<View> record(
      "The inertia phase of a gear change: one element slips at constant torque.",
      [](Record<View>& keys) {
        keys.word("status",
                  words_up_to(SlipEnd::never_synchronises),
                  "Whether the slip ends.",
                  [](const View& v) { return word_of(v.slip.end); });
        keys.text("from",
                  "The previous gear; null where the transmission was open.",
                  [](const View& v) {
                    return v.slip.from ? std::optional(state_name(v, *v.slip.from)) : std::nullopt;
                  })
            .not_in_tables();
        keys.text("to",
                  "The gear after the change.",
                  [](const View& v) { return state_name(v, v.slip.to); })
            .not_in_tables();
        keys.text("opens",
                  "The element that opens; null likewise.",
                  [](const View& v) {
                    return v.slip.opens ? std::optional(name_of_element(v.analysis, *v.slip.opens))
                                        : std::nullopt;
                  })
            .not_in_tables();
        keys.text("slips",
                  "The element that slips and engages.",
                  [](const View& v) { return name_of_element(v.analysis, v.slip.slips); })
            .not_in_tables();
        add_slip(keys);
        add_energies(keys);
        add_train(keys);
      });
  return record;
}

const Record<SlipObstacle>& slip_obstacle_record() {
  static const Record<SlipObstacle> record(
      "A change whose slip has no answer.", [](Record<SlipObstacle>& keys) {
        keys.text("reason", "What keeps it from having one.", [](const SlipObstacle& v) {
          return v.reason;
        });
      });
  return record;
}

}  // namespace kinestat
