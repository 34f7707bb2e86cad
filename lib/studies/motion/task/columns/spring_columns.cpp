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
                         const auto& placed,
                         double SpringState::*at) {
      readings.push_back({.column = {.element = std::string(kSpringPrefix) + spring.name,
                                     .quantity = quantity,
                                     .unit = units.text(kind)},
                          .kind = kind,
                          .value = [i, at, placed, &spring](
                                       const MotionPosition& position) -> std::optional<double> {
                            if (position.solved && i < position.solved->springs.size()) {
                              return position.solved->springs[i].*at;
                            }
                            const auto there = position.state.is_singular
                                                   ? placed_spring(spring,
                                                                   {.poses = position.state.poses,
                                                                    .positions = position.freedoms})
                                                   : std::nullopt;
                            return there ? placed(*there) : std::nullopt;
                          }});
    };
    add(
        quantities.position,
        quantities.position_kind,
        [](const PlacedSpring& one) { return std::optional(one.position); },
        &SpringState::position);
    add(
        quantities.action,
        quantities.action_kind,
        [](const PlacedSpring& one) { return one.force; },
        &SpringState::force);
  }
  return readings;
}

}  // namespace kinestat
