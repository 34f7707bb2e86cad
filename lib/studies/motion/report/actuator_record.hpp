// Records of what actuators have to do in a whole motion.
#pragma once

#include "record/record.hpp"
#include "studies/motion/report/motion_dynamics.hpp"

namespace kinestat {

struct ActuatorView {
  const MotionDynamics& of;
  const ActuatorFigures& actuator;
};

const Record<ActuatorView>& actuator_record();

/// The energies of the whole motion.
const Record<EnergyFigures>& energy_record();

}  // namespace kinestat
