// The fundamental circuits as lists of couplings.
#pragma once

#include <vector>

#include "core/types.hpp"
#include "graph/coupling_graph.hpp"

namespace kinestat {

/// A coupling of a circuit, +1 if the circuit passes it from tail to head.
struct CircuitEdge {
  CouplingId coupling;
  int sign = 1;
};

/// What a chord closes through the tree, in the order of the way round from the chord on; the chord
/// counts +1 (a row of B, Cazangi 2008, section 4.2, p. 72).
struct Circuit {
  CouplingId chord;
  std::vector<CircuitEdge> edges;
};

/// One a chord, in the order of the chords.
std::vector<Circuit> find_circuits(const CouplingGraph& graph);

}  // namespace kinestat
