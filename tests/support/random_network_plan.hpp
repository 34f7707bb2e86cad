// What a random network is to be made of, before its couplings have places.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/digraph.hpp"
#include "support/random_network_catalogue.hpp"

namespace kinestat {

/// A coupling without a place.
struct PlannedCoupling {
  Edge edge;
  CouplingType type = CouplingType::revolute;
};

struct NetworkPlan {
  Layout layout = Layout::general;
  Completeness completeness = Completeness::any;
  int body_count = 0;
  std::vector<PlannedCoupling> couplings;
  double actuated = 0.0;     ///< share of the freedoms
  bool names_world = false;  ///< some may be named by axes of the world
};

/// Seeds below this make networks of 3 to 30 bodies in the plane or in space, with few circuits;
/// the others networks of 3 to 12 bodies in space, with as many as leave some mobility.
inline constexpr std::uint64_t kFirstSmallSpatialSeed = 500;

NetworkPlan make_network_plan(std::uint64_t seed, Random& random);

}  // namespace kinestat
