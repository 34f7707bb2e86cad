#include "network/freedom_counts.hpp"

namespace kinestat {

MotionCounts motion_counts(const Mechanism& mechanism, int order, int system_rank) {
  const int F = mechanism.topology.freedom_count();
  // The velocity system also determines the twists of the n - 1 moving bodies.
  const int m = system_rank - order * (mechanism.topology.body_count() - 1);
  return {.order = order,
          .gross_freedom = F,
          .rank = m,
          .net_freedom = F - m,
          .net_constraint = order * mechanism.graph.circuit_count() - m};
}

ActionCounts action_counts(const Mechanism& mechanism, int order, int system_rank) {
  const int C = mechanism.topology.action_count();
  return {.order = order,
          .gross_constraint = C,
          .rank = system_rank,
          .net_constraint = C - system_rank,
          .net_freedom = order * mechanism.graph.cutset_count() - system_rank};
}

}  // namespace kinestat
