// Small hypergraphs up to the names of their vertices.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

namespace kinestat {

/// The vertices of an edge, ascending.
using Hyperedge = std::vector<std::uint8_t>;

/// Where each vertex goes.
using VertexMap = std::vector<std::uint8_t>;

/// A hypergraph in its canonical form. Some of the vertices, the first, keep their numbers; the
/// others are numbered as they first occur in the word, which of all words that an order of edges
/// and vertices gives is the least. Hence its beginnings are canonical words as well.
struct HypergraphForm {
  std::vector<Hyperedge> word;
  std::vector<VertexMap> automorphisms;  ///< of the vertices of the word, the identity among them
};

/// `kept` counts the vertices that keep their numbers; the numbers of the others are of any size.
/// No two edges are equal.
HypergraphForm canonical_form(const std::vector<Hyperedge>& edges, int kept);

}  // namespace kinestat
