// Power that circulates, 'recirculation' in reports: it loads its members without reaching the
// output.
#pragma once

#include <cstddef>
#include <vector>

#include "core/types.hpp"

namespace kinestat {

struct MeshPower;
struct PowerArc;

/// Bodies each of which sends power, by way of others, to all the others.
struct CirculatingPower {
  std::vector<BodyId> bodies;     ///< in the sense of the flow where that is a single circle
  std::vector<std::size_t> arcs;  ///< indices into PowerGraph::net, likewise
  bool rolls = false;             ///< whether a mesh among them rolls, and so loses power
};

/// The strong components of the graph that the `net` powers from shaft to shaft make.
std::vector<CirculatingPower> find_circulating_power(int body_count,
                                                     const std::vector<PowerArc>& net,
                                                     const std::vector<MeshPower>& meshes);

}  // namespace kinestat
