// Pieces of a motion in time between its corners, in which values are integrated by few places.
#pragma once

#include <span>
#include <vector>

#include "mechanism/motion_plan.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// A place at which values are read for an integral, and its weight there, both in steps.
struct TimePoint {
  double step = 0.0;
  double weight = 0.0;
};

/// Points of Gauss between two corners.
struct TimePiece {
  double begin = 0.0;  ///< in steps
  double end = 0.0;
  std::vector<TimePoint> points = {};
};

/// Those with points of their own: where a law lets drives move between two of its corners that are
/// too few steps apart to show it. There are as many points as mean squares of speeds,
/// accelerations and powers of the drives need, and 36 for each turn of one that rotates, or for
/// the whole way of one that slides: what the mechanism makes of it. The plan is one in time;
/// `corners`: in order, of the law and others, within the motion and without its ends.
std::vector<TimePiece> find_time_pieces(const Topology& topology,
                                        const MotionPlan& plan,
                                        double last_step,
                                        std::span<const double> corners);

}  // namespace kinestat
