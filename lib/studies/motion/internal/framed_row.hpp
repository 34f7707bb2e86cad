// A condition of closure between the frames of two bodies.
#pragma once

#include <vector>

#include "studies/motion/motion_network.hpp"

namespace kinestat {

/// Points and directions in the frames, lengths in sizes of the mechanism.
template <class Vector>
struct FramedRow {
  ClosureKind kind = ClosureKind::meet;
  int tail_frame = 0;
  int head_frame = 0;
  Vector tail_point = Vector::Zero();
  Vector head_point = Vector::Zero();
  Vector tail = Vector::Zero();
  Vector head = Vector::Zero();
  double value = 0.0;
  double tail_radius = 0.0;
  double head_radius = 0.0;
  int angle = -1;
  int first = 0;              ///< row of the system
  std::vector<int> rates;     ///< of the joints between the two frames
  std::vector<double> signs;  ///< +1: the joint moves the head
};

}  // namespace kinestat
