#include "kinematics/kinematic_solution.hpp"

#include <algorithm>

namespace kinestat {

bool KinematicSolution::knows_rate(int freedom) const {
  return std::ranges::none_of(idle, [freedom](const IdleFreedom& one) {
    return std::ranges::find(one.freedoms, freedom) != one.freedoms.end();
  });
}

bool KinematicSolution::knows_body(BodyId body) const {
  return std::ranges::none_of(idle, [body](const IdleFreedom& one) {
    return std::ranges::find(one.bodies, body) != one.bodies.end();
  });
}

}  // namespace kinestat
