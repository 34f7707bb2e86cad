// Loads that act on bodies from outside.
#pragma once

#include <optional>
#include <vector>

#include "description/value.hpp"

namespace kinestat {

/// The axes along which the components of a load stay while its body moves, in the order of the
/// words in files. In the drawn position they are the same.
enum class LoadFrame { world, body };

/// A force and a couple on a body; a load of a case replaces the one of its name at the top level.
struct LoadDescription {
  Name name;
  Name body;
  std::optional<PointDescription> at;     ///< where the force acts
  std::optional<PointDescription> force;  ///< vector [force]
  std::vector<Value> couple;  ///< [moment]: one number about z in the plane, three in space
  LoadFrame frame = LoadFrame::world;
};

}  // namespace kinestat
