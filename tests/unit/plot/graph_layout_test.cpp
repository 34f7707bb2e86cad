#include "draw/graph/graph_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

Digraph complete(int count) {
  Digraph graph{.vertex_count = count, .edges = {}};
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      graph.edges.push_back({.tail = a, .head = b});
    }
  }
  return graph;
}

Digraph circle(int count) {
  Digraph graph{.vertex_count = count, .edges = {}};
  for (int a = 0; a < count; ++a) {
    graph.edges.push_back({.tail = (7 * a) % count, .head = (7 * a + 7) % count});
  }
  return graph;
}

double least_distance(const std::vector<PixelPoint>& places) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      least = std::min(least, std::hypot(places[i].x - places[j].x, places[i].y - places[j].y));
    }
  }
  return least;
}

TEST(GraphLayout, KeepsNodesApart) {
  for (int count = 2; count < 20; ++count) {
    SCOPED_TRACE(count);
    EXPECT_GT(least_distance(lay_out(complete(count), 100.0)), 99.0);
    EXPECT_GT(least_distance(lay_out(circle(count), 100.0)), 99.0);
  }
}

TEST(GraphLayout, IsTheSameEveryTime) {
  const std::vector<PixelPoint> one = lay_out(complete(7), 100.0);
  const std::vector<PixelPoint> other = lay_out(complete(7), 100.0);

  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].x, other[i].x);
    EXPECT_EQ(one[i].y, other[i].y);
  }
}

// A circuit of nodes in any order is a ring.
TEST(GraphLayout, UnwindsARing) {
  for (const int count : {4, 6, 10, 12}) {
    const Digraph graph = circle(count);

    EXPECT_EQ(find_faults(graph, lay_out(graph, 100.0), 20.0).crossings, 0) << count;
  }
}

// Two triangles that share no node, joined by three edges: a prism, which is planar.
TEST(GraphLayout, LeadsNoEdgeAcrossANode) {
  const Digraph prism{
      .vertex_count = 6,
      .edges = {{0, 2}, {2, 4}, {4, 0}, {1, 3}, {3, 5}, {5, 1}, {0, 1}, {2, 3}, {4, 5}}};

  EXPECT_EQ(find_faults(prism, lay_out(prism, 100.0), 20.0).covered_nodes, 0);
}

TEST(LayoutFaults, CountCrossingsAndCoveredNodes) {
  // The diagonals of a square, and a node on one of them.
  const Digraph graph{.vertex_count = 5, .edges = {{0, 2}, {1, 3}}};
  const std::vector<PixelPoint> places = {{0, 0}, {100, 0}, {100, 100}, {0, 100}, {75, 80}};

  const LayoutFaults faults = find_faults(graph, places, 10.0);

  EXPECT_EQ(faults.crossings, 1);
  EXPECT_EQ(faults.covered_nodes, 1);
}

}  // namespace
}  // namespace kinestat
