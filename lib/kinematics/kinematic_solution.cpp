#include "kinematics/kinematic_solution.hpp"

#include <algorithm>

#include "screw/point_motion.hpp"

namespace kinestat {

namespace {

template <class Moves>
bool is_moved(const std::vector<IdleFreedom>& idle, BodyId body, const Moves& moves) {
  return std::ranges::any_of(idle, [&](const IdleFreedom& one) {
    const auto at = std::ranges::find(one.bodies, body);
    return at != one.bodies.end() &&
           moves(one.twists[static_cast<std::size_t>(at - one.bodies.begin())]);
  });
}

}  // namespace

bool KinematicSolution::knows_rate(int freedom) const {
  return std::ranges::none_of(idle, [freedom](const IdleFreedom& one) {
    return std::ranges::find(one.freedoms, freedom) != one.freedoms.end();
  });
}

bool KinematicSolution::knows_body(BodyId body) const {
  return !is_moved(idle, body, [](const Twist&) { return true; });
}

bool KinematicSolution::knows_turn(BodyId body, double length) const {
  return !is_moved(idle, body, [&](const Twist& twist) { return turns(twist, length); });
}

bool KinematicSolution::knows_velocity(BodyId body, const Vec3& point, double length) const {
  return !is_moved(
      idle, body, [&](const Twist& twist) { return moves_point(twist, point, length); });
}

}  // namespace kinestat
