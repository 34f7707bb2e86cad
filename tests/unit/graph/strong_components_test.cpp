#include <algorithm>
#include <chrono>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "graph/components.hpp"

namespace kinestat {
namespace {

using Parts = std::vector<std::vector<int>>;

Digraph random_graph(int vertex_count, int edge_count, std::mt19937& random) {
  std::uniform_int_distribution<int> vertex(0, vertex_count - 1);
  Digraph graph{.vertex_count = vertex_count, .edges = {}};
  for (int e = 0; e < edge_count; ++e) {
    const int tail = vertex(random);
    graph.edges.push_back({.tail = tail, .head = vertex(random)});
  }
  return graph;
}

// By the definition: the closure of what reaches what (Warshall), then pairs that reach each other.
Parts parts_by_closure(const Digraph& graph) {
  const auto n = static_cast<std::size_t>(graph.vertex_count);
  std::vector<std::vector<bool>> reaches(n, std::vector<bool>(n, false));
  for (const Edge& edge : graph.edges) {
    reaches[static_cast<std::size_t>(edge.tail)][static_cast<std::size_t>(edge.head)] = true;
  }
  for (std::size_t by = 0; by < n; ++by) {
    for (std::size_t from = 0; from < n; ++from) {
      for (std::size_t to = 0; reaches[from][by] && to < n; ++to) {
        reaches[from][to] = reaches[from][to] || reaches[by][to];
      }
    }
  }
  Parts parts;
  std::vector<bool> is_taken(n, false);
  for (std::size_t v = 0; v < n; ++v) {
    std::vector<int> part = {static_cast<int>(v)};
    for (std::size_t other = v + 1; other < n && !is_taken[v]; ++other) {
      if (reaches[v][other] && reaches[other][v]) {
        part.push_back(static_cast<int>(other));
        is_taken[other] = true;
      }
    }
    if (part.size() > 1) {
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

// A ring whose every vertex also leads a step back, a path of rings of two, and a path without any:
// graphs of one part, of half as many as vertices, and of none, which stay open to the end.
std::vector<Digraph> large_graphs(int count) {
  std::vector<Digraph> graphs(3, Digraph{.vertex_count = count, .edges = {}});
  for (int v = 0; v < count; ++v) {
    graphs[0].edges.push_back({.tail = v, .head = (v + 1) % count});
    graphs[0].edges.push_back({.tail = (v + 1) % count, .head = v});
    if (v + 1 < count) {
      graphs[1].edges.push_back({.tail = v, .head = v + 1});
      graphs[2].edges.push_back({.tail = v, .head = v + 1});
    }
    if (v % 2 == 1) {
      graphs[1].edges.push_back({.tail = v, .head = v - 1});
    }
  }
  return graphs;
}

double seconds_of(const std::vector<Digraph>& graphs) {
  double least = 1e9;
  for (int run = 0; run < 3; ++run) {
    const auto start = std::chrono::steady_clock::now();
    for (const Digraph& graph : graphs) {
      find_strong_components(graph);
    }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    least = std::min(least, time.count());
  }
  return least;
}

TEST(StrongComponents, OfAGraphWithoutCyclesAreNone) {
  EXPECT_EQ(find_strong_components({.vertex_count = 0, .edges = {}}), Parts{});
  EXPECT_EQ(find_strong_components({.vertex_count = 3, .edges = {{0, 1}, {0, 2}, {1, 2}}}),
            Parts{});
}

TEST(StrongComponents, AreTheVerticesOfACycleAndNotWhatLeadsThereOrAway) {
  const Digraph graph{.vertex_count = 6, .edges = {{0, 4}, {4, 2}, {2, 1}, {1, 4}, {1, 3}, {5, 0}}};

  EXPECT_EQ(find_strong_components(graph), Parts({{1, 2, 4}}));
}

TEST(StrongComponents, JoinCyclesThatShareAVertexButNotThoseThatAnEdgeJoins) {
  const Digraph graph{.vertex_count = 7,
                      .edges = {{0, 1}, {1, 0}, {1, 2}, {2, 1}, {2, 3}, {3, 4}, {4, 3}, {6, 5}}};

  EXPECT_EQ(find_strong_components(graph), Parts({{0, 1, 2}, {3, 4}}));
}

TEST(StrongComponents, LeaveOutAVertexThatReachesOnlyItself) {
  EXPECT_EQ(find_strong_components({.vertex_count = 2, .edges = {{0, 0}, {0, 1}}}), Parts{});
}

TEST(StrongComponents, OfACycleOfAHundredThousandVerticesNeedNoStack) {
  constexpr int kCount = 100000;
  Digraph graph{.vertex_count = kCount, .edges = {}};
  for (int v = 0; v < kCount; ++v) {
    graph.edges.push_back({.tail = v, .head = (v + 1) % kCount});
  }

  const Parts parts = find_strong_components(graph);

  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].size(), static_cast<std::size_t>(kCount));
}

TEST(StrongComponents, OfRandomGraphsAreThoseOfTheTransitiveClosure) {
  std::mt19937 random(20261124);
  for (int count = 1; count <= 40; ++count) {
    for (int edges = 0; edges <= 3 * count; edges += 1 + count / 5) {
      const Digraph graph = random_graph(count, edges, random);
      EXPECT_EQ(find_strong_components(graph), parts_by_closure(graph))
          << count << " vertices, " << edges << " edges";
    }
  }
}

// Ten times the vertices may take ten times as long, with room for memory that is no longer in the
// cache; a quadratic search takes a hundred times.
TEST(StrongComponents, TakeTimeThatGrowsAsTheGraph) {
  EXPECT_LT(seconds_of(large_graphs(100000)), 40 * seconds_of(large_graphs(10000)));
}

}  // namespace
}  // namespace kinestat
