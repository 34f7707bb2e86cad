#include "graph/digraph.hpp"

#include <gtest/gtest.h>

#include "unit/graph/graphs.hpp"

namespace kinestat {
namespace {

TEST(Incidence, IsPlusOneAtTheTailAndMinusOneAtTheHead) {
  MatXi expected(2, 3);
  expected << 1, 1, -1, -1, -1, 1;

  EXPECT_EQ(incidence(parallel_edges()), expected);
}

TEST(Incidence, HasColumnsThatSumToZero) {
  EXPECT_TRUE(incidence(ravigneaux_graph()).colwise().sum().isZero());
}

TEST(Incidence, OfASingleVertexHasNoColumns) {
  EXPECT_EQ(incidence(single_vertex()).rows(), 1);
  EXPECT_EQ(incidence(single_vertex()).cols(), 0);
}

}  // namespace
}  // namespace kinestat
