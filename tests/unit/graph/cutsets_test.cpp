#include "graph/cutsets.hpp"

#include <gtest/gtest.h>

#include "unit/graph/graphs.hpp"

namespace kinestat {
namespace {

// With the tree a, b, c, e, f, g.
CouplingGraph ravigneaux() {
  const Digraph graph = ravigneaux_graph();
  return make_coupling_graph(graph, *find_spanning_tree(graph, std::vector<int>{0, 1, 2, 4, 5, 6}));
}

// Columns in the order a to k.
MatXi in_edge_order(const CouplingGraph& graph, const MatXi& matrix) {
  MatXi result(matrix.rows(), matrix.cols());
  for (std::size_t c = 0; c < graph.columns.size(); ++c) {
    result.col(graph.columns[c]) = matrix.col(static_cast<Eigen::Index>(c));
  }
  return result;
}

TEST(Cutsets, OfTheRavigneauxTrainAreThoseOfTheSource) {
  // Cazangi 2008, Eq. 5.8 (as corrected): rows a, b, c, e, f, g.
  MatXi expected(6, 11);
  expected << 1, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0,  //
      0, 1, 0, 0, 0, 0, 0, 0, 0, -1, 0,          //
      0, 0, 1, -1, 0, 0, 0, 0, 0, 0, 1,          //
      0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0,           //
      0, 0, 0, 0, 0, 1, 0, 1, -1, 0, 0,          //
      0, 0, 0, 0, 0, 0, 1, 0, 1, 1, 1;

  const CouplingGraph graph = ravigneaux();

  EXPECT_EQ(in_edge_order(graph, cutset_matrix(graph)), expected);
}

TEST(Circuits, OfTheRavigneauxTrainAreThoseOfTheSource) {
  // Cazangi 2008, Eq. 5.10: rows d, h, i, j, k.
  MatXi expected(5, 11);
  expected << 0, 0, 1, 1, -1, 0, 0, 0, 0, 0, 0,  //
      1, 0, 0, 0, -1, -1, 0, 1, 0, 0, 0,         //
      0, 0, 0, 0, 0, 1, -1, 0, 1, 0, 0,          //
      0, 1, 0, 0, -1, 0, -1, 0, 0, 1, 0,         //
      0, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1;

  const CouplingGraph graph = ravigneaux();

  EXPECT_EQ(in_edge_order(graph, circuit_matrix(cutset_matrix(graph))), expected);
}

TEST(Cutsets, BeginWithTheIdentity) {
  EXPECT_EQ(cutset_matrix(ravigneaux()).leftCols(6), MatXi(MatXi::Identity(6, 6)));
}

TEST(Circuits, EndWithTheIdentity) {
  EXPECT_EQ(circuit_matrix(cutset_matrix(ravigneaux())).rightCols(5), MatXi(MatXi::Identity(5, 5)));
}

TEST(Cutsets, AreOrthogonalToCircuits) {
  const CouplingGraph graph = ravigneaux();

  EXPECT_TRUE((circuit_matrix(cutset_matrix(graph)) * cutset_matrix(graph).transpose()).isZero());
}

TEST(Circuits, OfParallelEdgesFollowTheDirectionOfTheChord) {
  const Digraph graph = parallel_edges();
  MatXi expected(2, 3);
  expected << -1, 1, 0, 1, 0, 1;

  EXPECT_EQ(circuit_matrix(cutset_matrix(make_coupling_graph(graph, *find_spanning_tree(graph)))),
            expected);
}

TEST(CouplingGraph, OfASingleVertexHasNeitherCutsetsNorCircuits) {
  const CouplingGraph graph =
      make_coupling_graph(single_vertex(), *find_spanning_tree(single_vertex()));

  EXPECT_EQ(graph.cutset_count(), 0);
  EXPECT_EQ(graph.circuit_count(), 0);
  EXPECT_EQ(circuit_matrix(cutset_matrix(graph)).size(), 0);
}

}  // namespace
}  // namespace kinestat
