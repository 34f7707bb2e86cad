// Where friction turns round on a motion.
#pragma once

#include <vector>

#include "mechanism/mechanism.hpp"
#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/motion_position.hpp"

namespace kinestat {

/// The motion against which each friction of the mechanism works at a position [rad/s or m/s]: the
/// rate of the one freedom of a bearing, guide or thread; the velocity along the freedoms that
/// slide of a contact, whose turns have no friction. Zero where the friction has no direction;
/// empty where no motion is known.
std::vector<Vec3> sliding_at(const Mechanism& mechanism, const MotionPosition& position);

/// Adds to the table the couplings that slide one way and then the other, by the sliding of each of
/// its rows. Rows between are at its dead point, wherever the steps fall; so are the first and the
/// last row where it rests in that one alone.
void find_friction_turns(const Mechanism& mechanism,
                         const std::vector<std::vector<Vec3>>& sliding,
                         MotionTable& table);

}  // namespace kinestat
