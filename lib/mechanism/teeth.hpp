// Which couplings are teeth that mesh.
#pragma once

#include "description/coupling_description.hpp"

namespace kinestat {

/// Between two wheels, each of which may be a planet.
constexpr bool joins_wheels(CouplingType type) {
  return type == CouplingType::gear || type == CouplingType::bevel_gear;
}

/// Of any two bodies.
constexpr bool has_teeth(CouplingType type) {
  return joins_wheels(type) || type == CouplingType::worm || type == CouplingType::rack;
}

}  // namespace kinestat
