// A directed graph: bodies are vertices, couplings are edges.
#pragma once

#include <vector>

#include "core/types.hpp"

namespace kinestat {

/// An edge from tail to head; parallel edges are allowed.
struct Edge {
  int tail = 0;
  int head = 0;
};

/// Vertices are numbered from 0; edges keep their order, which is the order of the file.
struct Digraph {
  int vertex_count = 0;
  std::vector<Edge> edges;

  int edge_count() const { return static_cast<int>(edges.size()); }
};

/// Incidence matrix, vertices x edges: +1 at the tail, -1 at the head (Cazangi 2008, eq. 2.2).
MatXi incidence(const Digraph& graph);

}  // namespace kinestat
