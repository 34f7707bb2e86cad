#include "dynamics/spring_record.hpp"

namespace kinestat {

const Record<SpringView>& spring_record() {
  static const Record<SpringView> record("One spring.", [](Record<SpringView>& keys) {
    using enum QuantityKind;
    const auto turns = [](const SpringView& v) { return v.turns(); };
    const auto slides = [](const SpringView& v) { return !v.turns(); };
    const auto position = [](const SpringView& v) { return v.state.position; };
    const auto action = [](const SpringView& v) { return v.state.force; };
    keys.quantity(
            "length",
            length,
            "Distance of its points; of a freedom that slides its position from the drawn one.",
            position)
        .only_if(slides);
    keys.quantity(
            "angle", angle, "Position of the freedom that turns, from the drawn one.", position)
        .only_if(turns);
    keys.quantity("force",
                  force,
                  "Its tension, negative where it pushes; of a freedom the action of tail on head.",
                  action)
        .only_if(slides);
    keys.quantity("couple", moment, "The couple of tail on head.", action).only_if(turns);
  });
  return record;
}

}  // namespace kinestat
