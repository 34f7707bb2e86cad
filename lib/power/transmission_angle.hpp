// The transmission angle: how well the force that drives an output is aimed.
#pragma once

#include <optional>

#include "mechanism/mechanism.hpp"

namespace kinestat {

/// The transmission angle μ [rad], from 0 to π/2, between the driving force of the output and the
/// normal of the path of its point of application. At 90° the force drives best, at 0° not at all.
/// Alt 1932 (Werkstattstechnik 26, 61) measures it in a four-bar between coupler and rocker; Balli
/// and Chand 2002 (Mechanism and Machine Theory 37, 175-195) review later definitions. Here it
/// follows from the actions, so that it means the same in sliders, cams and spatial mechanisms:
///   sin μ = |F · v| / (|F| |v|).
/// F is the force on the body of the output through its one other coupling that bears any, while
/// only input and output bear a load. v is the velocity that the freedom of the output gives this
/// body on the line of F, at its point next to the coupling. If the chain is stretched so that
/// neither can load it, F is the force of its self-stress, which is the limit of F in positions
/// nearby.
///
/// Empty if the body of the output is driven through no coupling, or several, by bodies other than
/// the one in which it is guided, if F is not determined by equilibrium or is a couple, or if v is
/// zero. `input` and `output` are indices of actuators.
std::optional<double> find_transmission_angle(const Mechanism& mechanism, int input, int output);

/// Why there is no transmission angle.
enum class TransmissionObstacle {
  same_actuator,    ///< input and output are one
  no_one_coupling,  ///< the body of the output is driven through no other coupling, or several
  open_force,       ///< equilibrium does not determine the force
  couple,           ///< a couple drives the body, not a force
  rest              ///< the body has no velocity on the line of the force
};

/// The reason why there is no transmission angle; empty if there is one.
std::optional<TransmissionObstacle> find_transmission_obstacle(const Mechanism& mechanism,
                                                               int input,
                                                               int output);

}  // namespace kinestat
