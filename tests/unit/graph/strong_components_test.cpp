#include "graph/strong_components.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

using Parts = std::vector<std::vector<int>>;

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

}  // namespace
}  // namespace kinestat
