// Graphs that several tests share.
#pragma once

#include "graph/cutsets.hpp"

namespace kinestat {

/// The coupling graph of the Ravigneaux train: bodies 0 (housing), 1, 2 (suns), 3 (ring), 4
/// (carrier), 5, 6 (planets); edges a to k. Cazangi 2008, section 5.2.
inline Digraph ravigneaux_graph() {
  return {
      .vertex_count = 7,
      .edges = {
          {0, 1}, {0, 2}, {3, 4}, {0, 3}, {0, 4}, {4, 5}, {4, 6}, {1, 5}, {5, 6}, {2, 6}, {3, 6}}};
}

/// Two vertices joined by three edges, the last against the others.
inline Digraph parallel_edges() {
  return {.vertex_count = 2, .edges = {{0, 1}, {0, 1}, {1, 0}}};
}

inline Digraph single_vertex() {
  return {.vertex_count = 1, .edges = {}};
}

/// Two parts: {0, 2} and {1, 3}.
inline Digraph two_parts() {
  return {.vertex_count = 4, .edges = {{0, 2}, {3, 1}}};
}

}  // namespace kinestat
