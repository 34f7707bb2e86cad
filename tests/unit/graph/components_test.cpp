#include "graph/components.hpp"

#include <gtest/gtest.h>

#include "unit/graph/graphs.hpp"

namespace kinestat {
namespace {

using Parts = std::vector<std::vector<int>>;

TEST(Components, OfAConnectedGraphAreOne) {
  EXPECT_EQ(find_components(ravigneaux_graph()), (Parts{{0, 1, 2, 3, 4, 5, 6}}));
}

TEST(Components, ComeInTheOrderOfTheirFirstVertex) {
  EXPECT_EQ(find_components(two_parts()), (Parts{{0, 2}, {1, 3}}));
}

TEST(Components, WithoutEdgesAreSingleVertices) {
  EXPECT_EQ(find_components({.vertex_count = 3, .edges = {}}), (Parts{{0}, {1}, {2}}));
}

TEST(Components, OfAGraphWithoutVerticesAreNone) {
  EXPECT_TRUE(find_components({}).empty());
}

}  // namespace
}  // namespace kinestat
