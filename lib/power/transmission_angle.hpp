// The transmission angle: how well the force that drives an output is aimed.
#pragma once

#include <optional>

#include "mechanism/mechanism.hpp"

namespace kinestat {

/// The angle μ of the output's driving force to the normal of the path on which it works [rad], 0
/// to π/2: 90° is best, at 0° the force does not drive at all. Alt 1932 (Werkstattstechnik 26, 61)
/// measures it in a four-bar between coupler and rocker; Balli and Chand 2002 (Mechanism and
/// Machine Theory 37, 175-195) collect what was made of it. Here it follows from the actions, so
/// that it means the same in sliders, cams and space:
///   sin μ = |F · v| / (|F| |v|),
/// F the force that reaches the body of the output through its one other coupling while nothing but
/// input and output bear a load, v the velocity which the output's freedom gives that body on the
/// line of F, at its point next to the coupling. Where the chain is stretched so that neither can
/// load it, F is that with which it may stress itself, the limit of what stands beside.
///
/// Empty where the body of the output has more than one other coupling that is not with the same
/// body, where F is not determined by equilibrium or is a couple, and where v is zero.
/// `input` and `output` are indices of actuators.
std::optional<double> find_transmission_angle(const Mechanism& mechanism, int input, int output);

/// Why there is no transmission angle.
enum class TransmissionObstacle {
  same_actuator,    ///< input and output are one
  no_one_coupling,  ///< the body of the output has no other coupling, or several
  open_force,       ///< equilibrium does not determine the force
  couple,           ///< what drives the body is a couple
  rest              ///< the body rests on the line of the force
};

/// Empty iff there is one.
std::optional<TransmissionObstacle> find_transmission_obstacle(const Mechanism& mechanism,
                                                               int input,
                                                               int output);

}  // namespace kinestat
