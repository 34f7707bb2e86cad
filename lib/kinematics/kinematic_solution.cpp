#include "kinematics/kinematic_solution.hpp"

#include <algorithm>

namespace kinestat {

double fastest_motion(const KinematicSolution& motion, double length) {
  double fastest = 0.0;
  for (const Twist& twist : motion.bodies) {
    fastest = std::max({fastest, length * twist.angular.norm(), twist.linear.norm()});
  }
  return fastest;
}

}  // namespace kinestat
