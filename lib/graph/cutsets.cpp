#include "graph/cutsets.hpp"

#include <utility>

#include "core/contract.hpp"

namespace kinestat {

namespace {

std::vector<int> branches_then_chords(const SpanningTree& tree) {
  std::vector<int> columns = tree.branches;
  columns.insert(columns.end(), tree.chords.begin(), tree.chords.end());
  return columns;
}

// Brings a +1 or -1 of column c to row c and clears the rest of the column. Entries stay -1, 0 or
// 1, because an incidence matrix is totally unimodular.
void reduce_column(MatXi& rows, Eigen::Index c) {
  Eigen::Index pivot = c;
  while (pivot < rows.rows() && rows(pivot, c) == 0) {
    ++pivot;
  }
  KINESTAT_EXPECTS(pivot < rows.rows());
  rows.row(c).swap(rows.row(pivot));
  if (rows(c, c) < 0) {
    rows.row(c) *= -1;
  }
  for (Eigen::Index r = 0; r < rows.rows(); ++r) {
    if (r != c && rows(r, c) != 0) {
      rows.row(r) -= rows(r, c) * rows.row(c);
    }
  }
}

}  // namespace

CouplingGraph make_coupling_graph(Digraph graph, SpanningTree tree) {
  CouplingGraph result;
  result.columns = branches_then_chords(tree);
  const Eigen::Index k = static_cast<Eigen::Index>(tree.branches.size());
  const Eigen::Index l = static_cast<Eigen::Index>(tree.chords.size());
  MatXi rows = incidence(graph)(Eigen::all, result.columns);
  for (Eigen::Index c = 0; c < k; ++c) {
    reduce_column(rows, c);
  }
  result.cutsets = rows.topRows(k);
  result.circuits = MatXi::Zero(l, k + l);
  result.circuits.leftCols(k) = -result.cutsets.rightCols(l).transpose();
  result.circuits.rightCols(l) = MatXi::Identity(l, l);
  result.graph = std::move(graph);
  result.tree = std::move(tree);
  return result;
}

}  // namespace kinestat
