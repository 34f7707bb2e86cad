// A load whose components follow curves.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "core/source.hpp"
#include "core/types.hpp"
#include "description/load_description.hpp"
#include "mechanism/curves/moving_number.hpp"
#include "screw/pose.hpp"

namespace kinestat {

/// A load whose components are known once position and motion of the mechanism are known.
struct MovingLoad {
  std::string name;
  BodyId body;
  std::optional<Vec3> point;  ///< where the force acts, from the origin of the geometry [m]; empty
                              ///< for a couple alone
  std::array<MovingNumber, 3> force;   ///< [N]
  std::array<MovingNumber, 3> couple;  ///< [N·m]
  LoadFrame frame = LoadFrame::world;
  Mat3 turn = Mat3::Identity();  ///< of the components, since they were drawn
  SourceRange where;
};

}  // namespace kinestat
