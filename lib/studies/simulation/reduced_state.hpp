// What a mechanism does in a state, or why nothing says it.
#pragma once

#include <optional>
#include <vector>

#include "dynamics/curve_loads.hpp"
#include "dynamics/spring_force.hpp"
#include "studies/motion/motion_state.hpp"

namespace kinestat {

/// Why a state has no accelerations.
struct SimulationObstacle {
  enum class Kind {
    no_branch,   ///< the closure cannot be followed there
    singular,    ///< the coordinates do not determine the velocities
    no_inertia,  ///< a freedom moves nothing that has mass or inertia
    rotor,       ///< a body of which only the inertia about one axis is known turns about another
    spring,      ///< nothing can be said of a spring
    curve,       ///< nor of what follows a curve
    friction_without_end,  ///< it grows with what it causes (Painleve)
    friction_in_two_ways,  ///< it balances, or goes on, in several ways
    no_loss,               ///< the loss of a mesh has no value at its speed
    open_friction,         ///< nothing says what presses, or how stuck couplings share
    stuck_in_circuit,      ///< a freedom would stick that is no joint of the tree
    beyond_stop,           ///< a freedom begins beyond its stop
    no_progress,           ///< stops are struck again and again at one time
    no_step,               ///< the steps of the integration vanish
    too_many_steps         ///< of the integration
  };

  Kind kind = Kind::no_branch;
  std::optional<SpringObstacle> of_spring = {};
  std::optional<CurveObstacle> of_curve = {};
  std::optional<BodyId> body = {};          ///< rotor
  std::optional<CouplingId> coupling = {};  ///< of friction
};

/// How a dry friction acts.
struct FrictionSense {
  int sense = 0;         ///< of its sliding; 0: it does not slide
  bool at_rest = false;  ///< with the coefficient of rest, as that which would have to give way
};

struct StatePowers {
  double supplied = 0.0;  ///< by actions, loads and held motions [W]
  double lost = 0.0;      ///< in dampers and friction [W]
};

/// The mechanism in a state.
struct ReducedState {
  MotionState state;                             ///< with all accelerations
  std::vector<std::optional<double>> positions;  ///< of the freedoms
  std::vector<double> held;                      ///< what each held coordinate takes [N·m or N]
  std::vector<double> actions;                   ///< that the case knows, in its order
  std::vector<std::optional<double>> friction;   ///< of each friction that slides, tail on head,
                                                 ///< dry and viscous
  std::vector<std::optional<double>> borne;      ///< of all actions, where asked for
  std::vector<double> load_powers;               ///< of loads, then those that follow curves [W]
  std::vector<SpringState> springs;              ///< of all springs
  std::optional<double> kinetic;                 ///< [J]; none in a singular position
  double potential = 0.0;                        ///< of weights and springs, as drawn zero [J]
};

}  // namespace kinestat
