// Lines about which bodies turn with or against each other.
#pragma once

#include <vector>

#include "mechanism/geometry.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Whether bodies turn about a common axis by it, so that it may be that of a gear.
bool is_hinge(CouplingType type);

/// Hinges on one line that bodies join to each other, and these bodies. A carrier is on two lines
/// at least: on one it turns itself, on others its planets do.
struct HingeLine {
  Vec3 direction = Vec3::Zero();  ///< a unit vector
  Vec3 point = Vec3::Zero();      ///< on it [m]
  std::vector<CouplingId> hinges;
  std::vector<BodyId> bodies;  ///< ascending
};

/// Of all hinges as they are drawn.
std::vector<HingeLine> find_hinge_lines(const Topology& topology, const Geometry& geometry);

/// Whether two of them are one but for rounding, although no body joins them.
bool are_one_line(const HingeLine& a, const HingeLine& b, double length);

}  // namespace kinestat
