#include "studies/shift/report/gear_part_records.hpp"

namespace kinestat {

const Record<CaseAnalysis>& gear_efficiency_record() {
  using View = CaseAnalysis;
  static const Record<View> record(
      "Power of the outputs over that of the inputs; null without friction and losses.",
      [](Record<View>& keys) {
        const auto of_meshes = [](Efficiency TransmissionEfficiency::*which) {
          return [which](const View& v) {
            return v.efficiency ? (*v.efficiency.*which).value : std::nullopt;
          };
        };
        keys.number("carrier",
                    Bare::efficiency,
                    "With mesh losses relative to their carriers; null where the file gives none, "
                    "or where they lock the gear.",
                    of_meshes(&TransmissionEfficiency::carrier));
        keys.number("carrier_backward",
                    Bare::efficiency,
                    "Likewise with the outputs driving.",
                    of_meshes(&TransmissionEfficiency::carrier_backward));
        keys.number("absolute",
                    Bare::efficiency,
                    "With losses by the power relative to the ground.",
                    of_meshes(&TransmissionEfficiency::absolute));
        keys.number("friction",
                    Bare::efficiency,
                    "With the friction of couplings alone.",
                    [](const View& v) { return v.power ? v.power->efficiency : std::nullopt; });
      });
  return record;
}

const Record<ElementView>& element_record() {
  using View = ElementView;
  static const Record<View> record("One element.", [](Record<View>& keys) {
    keys.quantity("torque",
                  QuantityKind::moment,
                  "Torque of tail on head without losses of meshes; zero of an open element.",
                  [](const View& v) { return v.torque; });
    keys.quantity("lossy_torque",
                  QuantityKind::moment,
                  "The same with mesh losses relative to their carriers, if the file gives any; "
                  "null where they lock the gear.",
                  [](const View& v) { return v.lossy_torque; })
        .only_if([](const View& v) { return v.has_lossy_meshes; });
    keys.quantity("slip",
                  QuantityKind::angular_velocity,
                  "Speed of head relative to tail; zero of an engaged element.",
                  [](const View& v) { return v.slip; });
  });
  return record;
}

}  // namespace kinestat
