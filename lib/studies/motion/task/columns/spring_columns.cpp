#include "studies/motion/task/columns/spring_columns.hpp"

#include <optional>
#include <string>

#include "mechanism/springs/spring_quantities.hpp"

namespace kinestat {

std::vector<MotionReading> spring_readings(const FileUnits& units, const Mechanism& mechanism) {
  std::vector<MotionReading> readings;
  for (std::size_t i = 0; i < mechanism.springs.size(); ++i) {
    const Spring& spring = mechanism.springs[i];
    const SpringQuantities& quantities = quantities_of(spring, mechanism.topology);
    const auto add = [&](const char* quantity,
                         QuantityKind kind,
                         double SpringState::*at,
                         std::optional<double> PlacedSpring::*at_place) {
      readings.push_back({.column = {.element = std::string(kSpringPrefix) + spring.name,
                                     .quantity = quantity,
                                     .unit = units.text(kind)},
                          .kind = kind,
                          .value = [i, at, at_place, &spring](
                                       const MotionPosition& position) -> std::optional<double> {
                            if (position.solved && i < position.solved->springs.size()) {
                              return position.solved->springs[i].*at;
                            }
                            return position.state.is_singular
                                       ? placed_spring(spring,
                                                       {.poses = position.state.poses,
                                                        .positions = position.freedoms}).*
                                             at_place
                                       : std::nullopt;
                          }});
    };
    add(quantities.position,
        quantities.position_kind,
        &SpringState::position,
        &PlacedSpring::position);
    add(quantities.action, quantities.action_kind, &SpringState::force, &PlacedSpring::force);
  }
  return readings;
}

}  // namespace kinestat
