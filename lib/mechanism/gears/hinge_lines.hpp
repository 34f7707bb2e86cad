// Lines of hinges, about which several bodies turn.
#pragma once

#include <vector>

#include "mechanism/geometry.hpp"
#include "mechanism/topology.hpp"

namespace kinestat {

/// Whether a coupling of this type is a hinge: its bodies turn about a common axis, which may be
/// that of a gear.
bool is_hinge(CouplingType type);

/// Hinges on one line that are connected by bodies, with these bodies. A carrier belongs to at
/// least two lines: it turns itself about one, and its planets turn about the others.
struct HingeLine {
  Vec3 direction = Vec3::Zero();  ///< a unit vector
  Vec3 point = Vec3::Zero();      ///< a point of the line [m]
  std::vector<CouplingId> hinges;
  std::vector<BodyId> bodies;  ///< ascending
};

/// Finds the lines of all hinges in the drawn position.
std::vector<HingeLine> find_hinge_lines(const Topology& topology, const Geometry& geometry);

/// Whether two lines coincide within rounding, even if no body connects them. `length` is the size
/// of the mechanism [m].
bool are_one_line(const HingeLine& a, const HingeLine& b, double length);

}  // namespace kinestat
