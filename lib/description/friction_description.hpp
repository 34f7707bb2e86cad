// Friction of one coupling.
#pragma once

#include <optional>

#include "description/value.hpp"

namespace kinestat {

/// `friction: 0.1` is `friction: {mu: 0.1}`.
struct FrictionDescription {
  std::optional<Value> mu;             ///< coefficient of friction
  std::optional<Value> mu_static;      ///< the same at rest
  std::optional<Value> radius;         ///< of a journal, mean radius of a thread, or the radius at
                                       ///< which a guide keeps from turning
  std::optional<Value> thrust_radius;  ///< mean radius of the collar that bears the axial force
  std::optional<Value> length;         ///< of a guide or a journal: its ends bear a couple across
  std::optional<Value> tau;            ///< couple of friction that does not depend on the load
  std::optional<Value> c;              ///< viscous couple per angular velocity
  SourceRange where;
};

}  // namespace kinestat
