// Friction of one coupling.
#pragma once

#include <optional>

#include "description/value.hpp"

namespace kinestat {

/// `friction: 0.1` is `friction: {mu: 0.1}`.
struct FrictionDescription {
  std::optional<Value> mu;      ///< coefficient of friction
  std::optional<Value> radius;  ///< of a journal, or mean radius of a thread
  std::optional<Value> length;  ///< of the guide of a prismatic coupling
  std::optional<Value> tau;     ///< couple of friction that does not depend on the load
  std::optional<Value> c;       ///< viscous couple per angular velocity
  SourceRange where;
};

}  // namespace kinestat
