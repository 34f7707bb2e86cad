// What reports say of one independent motion.
#pragma once

#include "expression/file_units.hpp"
#include "record/record.hpp"
#include "studies/mobility/motion_space.hpp"

namespace kinestat {

struct FreeMotionView {
  const Mechanism& mechanism;
  const FreeMotion& motion;
  const FileUnits& units;  ///< the motion is for one of them
};

const Record<FreeMotionView>& free_motion_record();

}  // namespace kinestat
