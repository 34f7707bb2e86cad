// A mechanism far from the origin of the world, described beside it.
#pragma once

#include <optional>

#include "description/mechanism_description.hpp"
#include "screw/pose.hpp"

namespace kinestat {

/// The description with every point measured from `origin` [m]: differences of the numbers as
/// typed, so that rounding to double takes nothing from what lies between the points. Empty if the
/// digits of a number are not known, or with cables, whose parts share their points.
std::optional<MechanismDescription> described_from(const MechanismDescription& description,
                                                   const Vec3& origin);

}  // namespace kinestat
