// What reports say of the velocities of a case.
#pragma once

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "record/record.hpp"

namespace kinestat {

struct KinematicView {
  const Mechanism& mechanism;
  const KinematicSolution& motion;
};

const Record<KinematicView>& kinematic_record();

}  // namespace kinestat
