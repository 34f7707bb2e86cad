// Where the power goes in one case, once velocities and actions are known.
#pragma once

#include <vector>

#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// All in W. Lists are parallel to those of the Topology.
struct PowerFlow {
  std::vector<double> into_head;  ///< of each coupling: its wrench on the motion of its head body
                                  ///< (Cazangi 2008, section 4.4.3, virtual power)
  std::vector<double> supplied;  ///< of each coupling: its wrench on its own motion; positive where
                                 ///< an actuator drives, negative where it brakes
  std::vector<double> actuators;  ///< of each actuator: its action times its rate
  double input = 0.0;             ///< of the inputs named by the case, else all positive actuators
  double balance_residual = 0.0;  ///< |sum of supplied| relative to the largest power
  bool is_balanced = true;        ///< the residual is at most kPowerBalance (Tellegen)
};

/// Both solutions must be solved, of the same mechanism and case.
PowerFlow find_power(const Mechanism& mechanism,
                     const Case& which,
                     const KinematicSolution& motion,
                     const StaticSolution& action);

}  // namespace kinestat
