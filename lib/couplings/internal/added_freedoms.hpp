// Freedoms that an upgrade of a coupling adds.
#pragma once

#include <array>
#include <vector>

#include "couplings/coupling_upgrade.hpp"

namespace kinestat {

/// Two directions across an axis, along the world where the axis is.
std::array<Vec3, 2> readable_across(const Vec3& axis);

std::vector<Twist> turns_about_all(const Vec3& point);

std::vector<CouplingUpgrade> with_turns_across(CouplingType to,
                                               const Vec3& axis,
                                               const Vec3& point);

}  // namespace kinestat
