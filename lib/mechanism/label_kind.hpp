// The kinds of quantity of freedoms and actions.
#pragma once

#include "expression/quantity.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// The kind of the position of a freedom.
constexpr QuantityKind position_kind(bool is_rotation) {
  return is_rotation ? QuantityKind::angle : QuantityKind::length;
}

/// The kind of the rate of a freedom.
constexpr QuantityKind rate_kind(bool is_rotation) {
  return is_rotation ? QuantityKind::angular_velocity : QuantityKind::velocity;
}

/// The kind of the magnitude of an action.
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
