#include "studies/shift/report/shift_parts.hpp"

namespace kinestat {

namespace {

bool is_of_torque(const LimitUse& v) {
  return v.part.limit.kind == LimitKind::torque;
}

bool is_of_speed(const LimitUse& v) {
  return !is_of_torque(v);
}

auto emit_changing(std::vector<int> GearChange::*elements) {
  return [elements](const ChangeView& v, const EachName& each) {
    for (const int element : v.change.*elements) {
      each(name_of_element(v.analysis, element));
    }
  };
}

void add_change_numbers(Record<ChangeView>& keys) {
  using View = ChangeView;
  keys.count("elements",
             "How many elements change: those that open and those that engage.",
             [](const View& v) { return v.change.elements(); });
  keys.number("step",
              Bare::number,
              "Ratio of the one gear over that of the other, of two forward gears.",
              [](const View& v) { return v.change.step; });
  keys.quantity(
      "slip",
      QuantityKind::angular_velocity,
      "Sum of the magnitudes of the slips, in the gear before, of the elements that engage, which "
      "they must absorb; null where one of them may slip freely.",
      [](const View& v) { return v.change.slip; });
  keys.quantity("slip_back",
                QuantityKind::angular_velocity,
                "Likewise of the change back.",
                [](const View& v) { return v.change.slip_back; });
}

}  // namespace

const std::string& name_of_actuator(const Analysis& analysis, int actuator) {
  return analysis.mechanism.topology.actuators[static_cast<std::size_t>(actuator)].name;
}

const std::string& name_of_element(const Analysis& analysis, int element) {
  const auto e = static_cast<std::size_t>(element);
  return name_of_actuator(analysis, analysis.shift->plan.elements[e].actuator);
}

const Record<LimitUse>& limit_record() {
  using View = LimitUse;
  static const Record<View> record("One limit.", [](Record<View>& keys) {
    const auto size = [](const View& v) { return v.size; };
    const auto most = [](const View& v) { return std::optional(v.part.limit.most); };
    keys.number("use",
                Bare::ratio,
                "Torque or speed over its limit; above 1 it is exceeded.",
                [](const View& v) { return v.use(); });
    keys.quantity("torque",
                  QuantityKind::moment,
                  "Magnitude of the torque, the larger of those without and with mesh losses.",
                  size)
        .only_if(is_of_torque);
    keys.quantity("largest_torque", QuantityKind::moment, "Its limit.", most).only_if(is_of_torque);
    keys.quantity("speed", QuantityKind::angular_velocity, "Magnitude of the slip or speed.", size)
        .only_if(is_of_speed);
    keys.quantity("largest_speed", QuantityKind::angular_velocity, "Its limit.", most)
        .only_if(is_of_speed);
  });
  return record;
}

const std::string& ChangeView::state(int index) const {
  return analysis.shift->solution.states[static_cast<std::size_t>(index)].name;
}

std::string ChangeView::name() const {
  return state(change.from) + " - " + state(change.to);
}

const Record<ChangeView>& change_number_record() {
  static const Record<ChangeView> record("Two gears.", add_change_numbers);
  return record;
}

const Record<ChangeView>& change_record() {
  using View = ChangeView;
  static const Record<View> record("Two gears.", [](Record<View>& keys) {
    keys.text("from", "One gear.", [](const View& v) { return v.state(v.change.from); });
    keys.text("to", "The other.", [](const View& v) { return v.state(v.change.to); });
    keys.names("opens",
               "The elements that open in this change; in the reverse change they engage.",
               emit_changing(&GearChange::opens));
    keys.names("engages",
               "The elements that engage in this change; in the reverse change they open.",
               emit_changing(&GearChange::engages));
    add_change_numbers(keys);
  });
  return record;
}

}  // namespace kinestat
