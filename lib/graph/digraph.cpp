#include "graph/digraph.hpp"

namespace kinestat {

MatXi incidence(const Digraph& graph) {
  MatXi result = MatXi::Zero(graph.vertex_count, graph.edge_count());
  for (int e = 0; e < graph.edge_count(); ++e) {
    result(graph.edges[static_cast<std::size_t>(e)].tail, e) += 1;
    result(graph.edges[static_cast<std::size_t>(e)].head, e) -= 1;
  }
  return result;
}

}  // namespace kinestat
