#include "dynamics/spring_obstacle_text.hpp"

#include <cmath>

#include <fmt/format.h>

namespace kinestat {

namespace {

bool is_too_long(const SpringObstacle& obstacle, const Spring& spring) {
  return spring.gas && obstacle.length > spring.gas->length;
}

// [m]
double limit_of(const SpringObstacle& obstacle, const Spring& spring) {
  const GasSpring& gas = *spring.gas;
  return is_too_long(obstacle, spring) ? gas.length : gas.length - gas.stroke;
}

std::string past_stroke_text(const SpringObstacle& obstacle,
                             const Spring& spring,
                             const FileUnits& units) {
  const auto text = [&](double metres) {
    return fmt::format(
        "{:.6g} {}", units.from_si(QuantityKind::length, metres), units.text(QuantityKind::length));
  };
  return fmt::format(
      "gas spring '{}' is past its stroke: its points are {} apart, {} {} the {} to which it can "
      "be {}",
      spring.name,
      text(obstacle.length),
      text(excess_of(obstacle, spring)),
      is_too_long(obstacle, spring) ? "more than" : "less than",
      text(limit_of(obstacle, spring)),
      limit_word(obstacle, spring));
}

}  // namespace

std::string text_of(const SpringObstacle& obstacle, const Spring& spring, const FileUnits& units) {
  switch (obstacle.kind) {
    case SpringObstacle::Kind::no_length:
      return fmt::format("spring '{}' has no direction, since its two points meet", spring.name);
    case SpringObstacle::Kind::past_stroke:
      return past_stroke_text(obstacle, spring, units);
    case SpringObstacle::Kind::no_position:
      return fmt::format("spring '{}' is of a freedom that has no position", spring.name);
    case SpringObstacle::Kind::no_speed:
      return fmt::format("spring '{}' damps, and the speeds of its ends are not known",
                         spring.name);
  }
  return "";
}

double excess_of(const SpringObstacle& obstacle, const Spring& spring) {
  return obstacle.kind == SpringObstacle::Kind::past_stroke
             ? std::abs(obstacle.length - limit_of(obstacle, spring))
             : 0.0;
}

std::string_view limit_word(const SpringObstacle& obstacle, const Spring& spring) {
  return is_too_long(obstacle, spring) ? "extended" : "compressed";
}

}  // namespace kinestat
