// What the inertia of the bodies does in a solved case.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/inertial_motion.hpp"
#include "statics/static_solution.hpp"

namespace kinestat {

/// Of a body with mass or inertia; wrenches are about the origin of the geometry.
struct BodyDynamics {
  BodyId body;
  Vec3 angular_acceleration = Vec3::Zero();  ///< [rad/s²]
  double angular_bound = 0.0;                ///< of each of its components
  Vec3 centre = Vec3::Zero();                ///< of mass [m]
  Vec3 centre_acceleration = Vec3::Zero();   ///< [m/s²]
  Wrench inertial;                           ///< D'Alembert's force and couple
  double kinetic_energy = 0.0;               ///< [J]
};

/// M q'' + h = Q + actions of the drives, of the freedoms that the case drives (Eksergian 1930):
/// rates in rad/s or m/s.
struct ReducedEquation {
  std::vector<int> drives;                 ///< freedoms
  std::vector<double> accelerations = {};  ///< q'', of each
  MatX inertia;                            ///< M
  VecX bias;                               ///< h: of the forces of inertia with steady drives
  std::optional<double> derivative;        ///< of M towards the position; of one drive alone
};

struct CaseDynamics {
  std::vector<BodyDynamics> bodies;
  double open_share = 0.0;      ///< by how much of the largest one forces of inertia may be off,
                                ///< as accelerations are hardly determined; else 0
  double kinetic_energy = 0.0;  ///< [J]
  double kinetic_energy_rate = 0.0;  ///< [W]
  std::optional<Wrench> shaking;     ///< all forces of inertia together; empty where the axis that
                                     ///< several planets stand around turns over
  std::optional<Wrench> ground;  ///< of all couplings and springs on the ground; likewise, where a
                                 ///< load acts on such planets, and where equilibrium has no answer
  std::optional<ReducedEquation> reduced;  ///< empty without the motions of the drives alone
  std::optional<double> two_ways;  ///< virtual power of all that acts on the motion of each drive:
                                   ///< the largest sum relative to its largest term, which is zero
                                   ///< but for rounding; empty where some action is open, and
                                   ///< without these motions
};

/// `mechanism` stands where the motion is, and `which` has the loads that act there, the forces of
/// inertia among them.
CaseDynamics find_dynamics(const Mechanism& mechanism,
                           const Case& which,
                           const InertialMotion& motion,
                           const StaticSolution* action);

}  // namespace kinestat
