// Power that circulates, 'recirculation' in reports: it loads its members without reaching the
// output.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/types.hpp"

namespace kinestat {

struct MeshPower;
struct PowerArc;

/// A group of bodies in which power circulates: each of them sends power to all the others,
/// directly or through other bodies.
struct CirculatingPower {
  std::vector<BodyId> bodies;     ///< in the sense of the flow if this is a single circle
  std::vector<std::size_t> arcs;  ///< indices into PowerGraph::net, in the same order
  double largest = 0.0;           ///< the largest power of its arcs [W]
  bool rolls = false;             ///< whether a mesh among the arcs rolls, and so may lose power
};

/// Finds the strong components of the graph of the `net` powers from shaft to shaft.
std::vector<CirculatingPower> find_circulating_power(int body_count,
                                                     const std::vector<PowerArc>& net,
                                                     const std::vector<MeshPower>& meshes);

/// The recirculation factor γ: the largest of the `net` powers over `input`, the power of the
/// inputs [W]. It exceeds one only if power circulates. Empty without input.
std::optional<double> find_recirculation(const std::vector<PowerArc>& net, double input);

}  // namespace kinestat
