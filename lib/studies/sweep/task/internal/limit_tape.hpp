// What a gear takes of its limits, on a tape.
#pragma once

#include <optional>

#include "math/tapes/lane_recorder.hpp"
#include "studies/sweep/task/power_tape.hpp"

namespace kinestat {

/// A gear without and with losses of its meshes; null what it does not have.
struct TapedGear {
  const TapedSide& motion;  ///< with the motions of bodies
  const TapedSide* action = nullptr;
  const TapedSide* lossy_action = nullptr;
};

/// The largest of its torques and speeds over their limits. Empty where the whole analysis must
/// find it: a limit varies, a body turns about more than one axis of the world, or a torque is not
/// known.
std::optional<TapeNumber> record_limit_use(const SweepTask& task,
                                           const TapedGear& gear,
                                           LaneRecorder& recorder);

}  // namespace kinestat
