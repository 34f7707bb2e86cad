// A load whose size follows curves.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/source.hpp"
#include "core/types.hpp"
#include "mechanism/curves/moving_number.hpp"

namespace kinestat {

/// In world directions; what it does is known once it is known how the mechanism stands and moves.
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
