#include "dynamics/spring_record.hpp"

namespace kinestat {

const Record<SpringView>& spring_record() {
  static const Record<SpringView> record("One spring.", [](Record<SpringView>& keys) {
    const auto turns = [](const SpringView& v) { return v.turns(); };
    const auto slides = [](const SpringView& v) { return !v.turns(); };
    const auto position = [](const SpringView& v) { return v.state.position; };
    const auto action = [](const SpringView& v) { return v.state.force; };
    keys.quantity(kSlidingSpring.position,
                  kSlidingSpring.position_kind,
                  "Distance of its points; of a freedom that slides its position from the drawn "
                  "one.",
                  position)
        .only_if(slides);
    keys.quantity(kTurningSpring.position,
                  kTurningSpring.position_kind,
                  "Position of the freedom that turns, from the drawn one.",
                  position)
        .only_if(turns);
    keys.quantity(kSlidingSpring.action,
                  kSlidingSpring.action_kind,
                  "Its tension, negative where it pushes; of a freedom the action of tail on head.",
                  action)
        .only_if(slides);
    keys.quantity(kTurningSpring.action,
                  kTurningSpring.action_kind,
                  "The couple of tail on head.",
                  action)
        .only_if(turns);
  });
  return record;
}

}  // namespace kinestat
