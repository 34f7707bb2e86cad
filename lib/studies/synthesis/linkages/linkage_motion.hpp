// A linkage carried through all of a circuit.
#pragma once

#include <vector>

#include "studies/synthesis/linkages/drive_curve.hpp"
#include "studies/synthesis/linkages/linkage.hpp"

namespace kinestat {

struct LinkageMotion {
  std::vector<Pose> poses;
  bool is_closed = false;  ///< the last pose leads back to the first
};

/// Poses along the circuit that holds `start`, `count` of them and about equally far from each
/// other: over the full turn of the input, or forth on one side of its dead points and back on the
/// other. What reaches to infinity is cut at `reach` [length] of a sliding input.
LinkageMotion trace_circuit(
    const Linkage& linkage, Drive drive, const Pose& start, int count, double reach);

/// The path of a point of the moving plane [moving frame] along those poses.
std::vector<Point> coupler_curve(const LinkageMotion& motion, const Point& moving);

}  // namespace kinestat
