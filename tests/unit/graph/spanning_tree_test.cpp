#include "graph/spanning_tree.hpp"

#include <gtest/gtest.h>

#include "unit/graph/graphs.hpp"

namespace kinestat {
namespace {

// Edges a to k as 0 to 10.
TEST(SpanningTree, TakesTheFirstEdgesThatCloseNoCircuit) {
  const auto tree = find_spanning_tree(ravigneaux_graph());

  ASSERT_TRUE(tree.has_value());
  EXPECT_EQ(tree->branches, (std::vector<int>{0, 1, 2, 3, 5, 6}));
  EXPECT_EQ(tree->chords, (std::vector<int>{4, 7, 8, 9, 10}));
}

TEST(SpanningTree, KeepsTheGivenOrderOfItsBranches) {
  const auto tree = find_spanning_tree(ravigneaux_graph(), std::vector<int>{6, 5, 4, 2, 1, 0});

  ASSERT_TRUE(tree.has_value());
  EXPECT_EQ(tree->branches, (std::vector<int>{6, 5, 4, 2, 1, 0}));
}

TEST(SpanningTree, IsRefusedIfTheBranchesCloseACircuit) {
  // c, d, e join 0, 3 and 4 in a circuit.
  EXPECT_FALSE(find_spanning_tree(ravigneaux_graph(), std::vector<int>{0, 1, 2, 3, 4, 5}));
}

TEST(SpanningTree, IsRefusedIfABranchIsMissing) {
  EXPECT_FALSE(find_spanning_tree(ravigneaux_graph(), std::vector<int>{0, 1, 2, 4, 5}));
}

TEST(SpanningTree, IsRefusedIfABranchIsGivenTwice) {
  EXPECT_FALSE(find_spanning_tree(ravigneaux_graph(), std::vector<int>{0, 1, 2, 4, 5, 5}));
}

TEST(SpanningTree, OfAGraphInPartsIsEmpty) {
  EXPECT_FALSE(find_spanning_tree(two_parts()).has_value());
}

TEST(SpanningTree, OfParallelEdgesHasOneBranch) {
  const auto tree = find_spanning_tree(parallel_edges());

  ASSERT_TRUE(tree.has_value());
  EXPECT_EQ(tree->branches, std::vector<int>{0});
  EXPECT_EQ(tree->chords, (std::vector<int>{1, 2}));
}

TEST(SpanningTree, OfASingleVertexHasNoBranches) {
  const auto tree = find_spanning_tree(single_vertex());

  ASSERT_TRUE(tree.has_value());
  EXPECT_TRUE(tree->branches.empty());
}

}  // namespace
}  // namespace kinestat
