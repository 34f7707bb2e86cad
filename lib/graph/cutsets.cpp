#include "graph/cutsets.hpp"

#include "core/contract.hpp"

namespace kinestat {

namespace {

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

MatXi cutset_matrix(const CouplingGraph& graph) {
  const Eigen::Index k = graph.cutset_count();
  MatXi rows = incidence(graph.graph)(Eigen::all, graph.columns);
  for (Eigen::Index c = 0; c < k; ++c) {
    reduce_column(rows, c);
  }
  return rows.topRows(k);
}

MatXi circuit_matrix(const MatXi& cutsets) {
  const Eigen::Index k = cutsets.rows();
  const Eigen::Index l = cutsets.cols() - k;
  MatXi circuits(l, k + l);
  circuits.leftCols(k) = -cutsets.rightCols(l).transpose();
  circuits.rightCols(l) = MatXi::Identity(l, l);
  return circuits;
}

}  // namespace kinestat
