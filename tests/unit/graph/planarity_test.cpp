#include "graph/planarity.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace kinestat {
namespace {

using Edges = std::vector<std::array<std::uint8_t, 2>>;

Edges complete(int vertices) {
  Edges edges;
  for (int a = 0; a < vertices; ++a) {
    for (int b = a + 1; b < vertices; ++b) {
      edges.push_back({static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)});
    }
  }
  return edges;
}

// Boyer and Myrvold 2004.
bool is_planar_by_boost(int vertices, const Edges& edges) {
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> graph(
      static_cast<std::size_t>(vertices));
  for (const auto& [a, b] : edges) {
    boost::add_edge(a, b, graph);
  }
  return boost::boyer_myrvold_planarity_test(graph);
}

TEST(Planarity, OfFourPointsAllJoined) {
  EXPECT_TRUE(is_planar(4, complete(4)));
}

TEST(Planarity, NotOfFivePointsAllJoined) {
  EXPECT_FALSE(is_planar(5, complete(5)));
}

TEST(Planarity, OfFivePointsButForOneEdge) {
  Edges edges = complete(5);
  edges.pop_back();
  EXPECT_TRUE(is_planar(5, edges));
}

TEST(Planarity, NotOfThreeHousesAndThreeWells) {
  Edges edges;
  for (std::uint8_t a = 0; a < 3; ++a) {
    for (std::uint8_t b = 3; b < 6; ++b) {
      edges.push_back({a, b});
    }
  }
  EXPECT_FALSE(is_planar(6, edges));
}

TEST(Planarity, DoesNotChangeWhereEdgesAreRepeated) {
  EXPECT_TRUE(is_planar(3, Edges{{0, 1}, {0, 1}, {1, 1}, {1, 2}, {2, 0}, {0, 1}}));
}

TEST(Planarity, OfPartsThatShareAPoint) {
  Edges edges = complete(4);
  for (const auto& [a, b] : complete(4)) {
    edges.push_back({static_cast<std::uint8_t>(a + 3), static_cast<std::uint8_t>(b + 3)});
  }
  EXPECT_TRUE(is_planar(7, edges));
}

class Planarities : public ::testing::TestWithParam<int> {};

TEST_P(Planarities, AreThoseOfASecondAlgorithm) {
  Random random(static_cast<std::uint64_t>(GetParam()));
  int planar = 0;
  for (int graph = 0; graph < 400; ++graph) {
    const int vertices = random.whole(5, 16);
    Edges edges;
    for (int i = random.whole(vertices, 2 * vertices + 4); i > 0; --i) {
      const int a = random.whole(0, vertices - 1);
      const int b = random.whole(0, vertices - 1);
      if (a != b) {
        edges.push_back({static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)});
      }
    }
    const bool expected = is_planar_by_boost(vertices, edges);
    ASSERT_EQ(is_planar(vertices, edges), expected);
    planar += expected ? 1 : 0;
  }
  EXPECT_GT(planar, 50);
  EXPECT_LT(planar, 350);
}

INSTANTIATE_TEST_SUITE_P(Random, Planarities, ::testing::Range(0, 10));

}  // namespace
}  // namespace kinestat
