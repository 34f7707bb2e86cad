// What the numbers of freedoms and actions measure.
#pragma once

#include "expression/quantity.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Of where a freedom stands.
constexpr QuantityKind position_kind(bool is_rotation) {
  return is_rotation ? QuantityKind::angle : QuantityKind::length;
}

/// Of the rate of a freedom.
constexpr QuantityKind rate_kind(bool is_rotation) {
  return is_rotation ? QuantityKind::angular_velocity : QuantityKind::velocity;
}

/// Of the magnitude of an action.
constexpr QuantityKind action_kind(bool is_couple) {
  return is_couple ? QuantityKind::moment : QuantityKind::force;
}

inline QuantityKind kind_of(const FreedomLabel& freedom) {
  return rate_kind(freedom.is_rotation);
}

inline QuantityKind kind_of(const ActionLabel& action) {
  return action_kind(action.is_couple);
}

}  // namespace kinestat
