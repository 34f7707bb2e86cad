// What a twist moves, beside what is rounding in a mechanism of some size.
#pragma once

#include "screw/twist.hpp"

namespace kinestat {

/// Whether a point [m] moves: not if it lies on the axis about which the twist turns.
bool moves_point(const Twist& twist, const Vec3& point, double length);

/// Whether directions turn: not by a slide.
bool turns(const Twist& twist, double length);

}  // namespace kinestat
