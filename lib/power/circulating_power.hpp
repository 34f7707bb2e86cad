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

/// Bodies each of which sends power, by way of others, to all the others.
struct CirculatingPower {
  std::vector<BodyId> bodies;     ///< in the sense of the flow where that is a single circle
  std::vector<std::size_t> arcs;  ///< indices into PowerGraph::net, likewise
  double largest = 0.0;           ///< power of its arcs [W]
  bool rolls = false;             ///< whether a mesh among them rolls, and so loses power
};

/// The strong components of the graph that the `net` powers from shaft to shaft make.
std::vector<CirculatingPower> find_circulating_power(int body_count,
                                                     const std::vector<PowerArc>& net,
                                                     const std::vector<MeshPower>& meshes);

/// γ, the recirculation factor: the largest of the `net` powers over the power of the inputs [W].
/// Above one only where power circulates; empty without input.
std::optional<double> find_recirculation(const std::vector<PowerArc>& net, double input);

}  // namespace kinestat
