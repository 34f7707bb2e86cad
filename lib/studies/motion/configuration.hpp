// Poses of bodies and positions of freedoms in a configuration.
#pragma once

#include <optional>
#include <vector>

#include "studies/motion/motion_solution.hpp"

namespace kinestat {

/// The drawn position: all coordinates zero.
Configuration drawn_configuration(const MotionNetwork& network);

/// Of each body, relative to where it was drawn, in the world frame [m].
std::vector<BodyPose> body_poses(const MotionNetwork& network, const Configuration& configuration);

/// In the plane: how far each body has turned about +z since it was drawn [rad], full turns
/// counted.
std::vector<double> body_turns(const MotionNetwork& network, const Configuration& configuration);

/// How far each freedom has moved from the drawn position [rad or m], turns counted; empty where a
/// freedom has no position: of balls, contacts, cables.
std::vector<std::optional<double>> freedom_positions(const MotionNetwork& network,
                                                     const Mechanism& mechanism,
                                                     const Configuration& configuration);

/// How far each cable bends around its pulley [rad], full turns counted; parallel to the arcs of
/// the network.
std::vector<double> contact_arcs(const MotionNetwork& network, const Configuration& configuration);

/// How far each coupling outside the tree misses closure; those above `least` as share of the
/// mechanism's size.
std::vector<CouplingMiss> find_misses(const MotionNetwork& network,
                                      const Configuration& configuration,
                                      double least);

/// The largest of them as share of the mechanism's size.
double closure_error(const MotionNetwork& network, const Configuration& configuration);

}  // namespace kinestat
