// How the bodies of a mechanism move and speed up in one position.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dynamics/body_inertia.hpp"
#include "kinematics/kinematic_solution.hpp"
#include "mechanism/mechanism.hpp"
#include "studies/motion/motion_state.hpp"

namespace kinestat {

/// A body with mass or inertia where it stands.
struct InertialBody {
  BodyId body;
  BodyInertia inertia;
  BoundedWrench bounded;  ///< D'Alembert's
  Wrench acts;            ///< likewise, with zero for what is mere rounding
};

/// What is worked out of a motion with inertia.
enum class InertiaDetail {
  forces,   ///< of inertia alone
  equation  ///< the motions of the drives alone, too, for the reduced equation
};

/// Lists of bodies are parallel to the topology; twists are about the origin of the geometry.
struct InertialMotion {
  std::vector<Twist> twists;
  std::vector<Twist> twist_rates;                     ///< time derivatives
  std::vector<BodyBounds> bounds;                     ///< how far all of these may be off
  std::vector<InertialBody> inertial;                 ///< those that have any, in order
  double open_share = 0.0;                            ///< see CaseDynamics
  std::vector<int> drives;                            ///< freedoms whose rates determine all others
  std::vector<double> rates;                          ///< of the drives [rad/s or m/s]
  std::vector<double> accelerations;                  ///< of the drives [rad/s² or m/s²]
  std::vector<std::vector<Twist>> of_drives;          ///< for a unit rate of each drive alone;
                                                      ///< empty for forces alone
  std::vector<std::vector<BodyBounds>> drive_bounds;  ///< how far these may be off
};

/// Why accelerations are not known.
struct InertiaObstacle {
  enum class Kind {
    unknown_motion,  ///< the case does not determine the velocities
    unmovable,       ///< a coupling has no finite law
    singular,        ///< velocities determine no accelerations
    idle_spin        ///< a body turns by itself, and its inertia about that axis counts
  };

  Kind kind = Kind::unknown_motion;
  std::optional<UnmovableCoupling> coupling = {};  ///< unmovable
  std::optional<BodyId> body = {};                 ///< idle_spin
};

/// Of a mechanism in its drawn position, moved by what the case knows; `motion` are its velocities.
std::variant<InertialMotion, InertiaObstacle> find_drawn_motion(const Mechanism& mechanism,
                                                                const Case& which,
                                                                const KinematicSolution& motion);

/// In any position: `states` are of a network that is driven by `drives`, whose speeds are given.
/// What a body does by itself is open: forces of inertia must not hang on it.
std::variant<InertialMotion, InertiaObstacle> find_inertial_motion(
    const Mechanism& mechanism,
    const MotionNetwork& network,
    MotionStates& states,
    const Configuration& configuration,
    const GivenSpeeds& speeds);

/// The same of the state that those speeds have there, with bounds and accelerations.
std::variant<InertialMotion, InertiaObstacle> inertial_motion_of(const MotionState& state,
                                                                 const Mechanism& mechanism,
                                                                 const MotionNetwork& network,
                                                                 MotionStates& states,
                                                                 const Configuration& configuration,
                                                                 const GivenSpeeds& speeds,
                                                                 InertiaDetail detail);

/// One load inertia.BODY for every body with mass or inertia, at its centre of mass; of planets
/// that of all of them together. Their names are `inertial_load_names`, in that order.
std::vector<Load> inertial_loads(const Mechanism& mechanism, const InertialMotion& motion);

std::vector<std::string> inertial_load_names(const Mechanism& mechanism);

}  // namespace kinestat
