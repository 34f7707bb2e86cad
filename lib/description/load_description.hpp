// Loads that act on bodies from outside.
#pragma once

#include <optional>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// A force and a couple on a body; a load of a case replaces the one of its name at the top level.
struct LoadDescription {
  Name name;
  Name body;
  std::optional<PointDescription> at;     ///< where the force acts
  std::optional<PointDescription> force;  ///< vector [force]
  std::vector<Value> couple;  ///< [moment]: one number about z in the plane, three in space
};

}  // namespace kinestat
