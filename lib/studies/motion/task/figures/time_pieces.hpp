// Pieces of a motion in time between its corners, in which values are integrated by few places.
#pragma once

#include <span>
#include <vector>

#include "mechanism/drive_schedule.hpp"

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
/// too few steps apart to show it. There are as many points as mean squares of the speeds and
/// accelerations of the drives need. `corners`: in order, of the law and others, within the motion
/// and without its ends.
std::vector<TimePiece> find_time_pieces(const DriveSchedule& schedule,
                                        int steps,
                                        double last_step,
                                        std::span<const double> corners);

}  // namespace kinestat
