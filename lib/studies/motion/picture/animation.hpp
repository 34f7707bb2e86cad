// A picture of a mechanism that goes through its motion by itself.
#pragma once

#include <string>

#include "cases/analysis.hpp"
#include "draw/linkage/drawn_motion.hpp"
#include "draw/picture.hpp"
#include "studies/motion/report/motion_table.hpp"
#include "studies/motion/task/found_motion.hpp"

namespace kinestat {

/// A mechanism as drawn, and the positions through which a picture of it goes.
struct MovingMechanism {
  Analysis still;  ///< without counts and cases
  DrawnMotion motion;
};

/// With as many positions as it takes to look smooth: those of the motion, some of them, or others
/// between them. Its drawing must close.
MovingMechanism moving_mechanism(std::string file,
                                 const MechanismDescription& description,
                                 const Mechanism& mechanism,
                                 const FoundMotion& found);

/// Without names, forces and drives, which would have to move too. A motion that comes back to
/// where it began goes round, any other there and back. There must be two positions; `table` is of
/// the same motion.
Picture draw_animation(const MovingMechanism& moving, const MotionTable& table);

}  // namespace kinestat
