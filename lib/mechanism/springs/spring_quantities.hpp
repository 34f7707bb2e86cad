// What the position of a spring and its action are, in reports and columns.
#pragma once

#include "expression/units.hpp"
#include "mechanism/springs/spring.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

struct SpringQuantities {
  const char* position;
  QuantityKind position_kind;
  const char* action;
  QuantityKind action_kind;
};

inline constexpr SpringQuantities kSlidingSpring = {.position = "length",
                                                    .position_kind = QuantityKind::length,
                                                    .action = "force",
                                                    .action_kind = QuantityKind::force};
inline constexpr SpringQuantities kTurningSpring = {.position = "angle",
                                                    .position_kind = QuantityKind::angle,
                                                    .action = "couple",
                                                    .action_kind = QuantityKind::moment};

/// Whether it is about a freedom that turns.
inline bool is_about_turn(const Spring& spring, const Topology& topology) {
  return spring.is_of_freedom() &&
         topology.freedoms[static_cast<std::size_t>(spring.freedom)].is_rotation;
}

inline const SpringQuantities& quantities_of(const Spring& spring, const Topology& topology) {
  return is_about_turn(spring, topology) ? kTurningSpring : kSlidingSpring;
}

}  // namespace kinestat
