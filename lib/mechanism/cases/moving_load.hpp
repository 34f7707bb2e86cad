// A load whose components follow curves.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/source.hpp"
#include "core/types.hpp"
#include "mechanism/curves/moving_number.hpp"

namespace kinestat {

/// A load in directions of the world. Its components are known once position and motion of the
/// mechanism are known.
struct MovingLoad {
  std::string name;
  BodyId body;
  std::optional<Vec3> point;  ///< where the force acts, from the origin of the geometry [m]; empty
                              ///< for a couple alone
  std::array<MovingNumber, 3> force;   ///< [N]
  std::array<MovingNumber, 3> couple;  ///< [N·m]
  SourceRange where;
};

}  // namespace kinestat
