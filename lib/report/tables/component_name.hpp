// What tables call the components of a vector or a screw.
#pragma once

#include <cstddef>
#include <string>

#include "record/shape.hpp"

namespace kinestat {

/// x, y, z of a point or a vector; of a screw as freedoms and actions are named: wx … vz of a
/// twist, Tx … Rz of a wrench; of anything else the number.
std::string component_name(const Shape& tuple, std::size_t index);

/// "x", "y" or "z".
std::string axis_name(std::size_t index);

}  // namespace kinestat
