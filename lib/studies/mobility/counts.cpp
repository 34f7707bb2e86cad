#include "studies/mobility/counts.hpp"

#include <algorithm>

#include "math/elimination/elimination.hpp"
#include "network/bases.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

ActionCounts count_actions_in(const Mechanism& mechanism, const CoordinateBasis& basis) {
  const Elimination elimination(action_system(mechanism.topology, mechanism.geometry, basis), {});
  return action_counts(mechanism, basis.order(), elimination.rank());
}

MotionCounts count_motions_in(const Mechanism& mechanism, const CoordinateBasis& basis) {
  const Elimination elimination(velocity_system(mechanism.topology, mechanism.geometry, basis), {});
  return motion_counts(mechanism, basis.order(), elimination.rank());
}

// Whether every screw lies in the rows 2, 3, 4: wz, vx, vy or Tz, Fx, Fy.
bool is_planar(const CoordinateBasis& basis) {
  return std::ranges::all_of(basis.coordinates, [](int c) { return c >= 2 && c <= 4; }) &&
         (basis.is_made_of_coordinates() || basis.order() == 0);
}

// A planar mechanism whose statics are not written in space.
bool is_planar_static(const Mechanism& mechanism) {
  return mechanism.space == Space::planar && mechanism.static_order != OrderChoice::spatial;
}

// rank M_N does not depend on the order, as long as it holds all motions.
MotionCounts in_order(MotionCounts counts, int order, int circuit_count) {
  counts.order = order;
  counts.net_constraint = order * circuit_count - counts.rank;
  return counts;
}

}  // namespace

MobilityCounts count_motions(const Mechanism& mechanism, const Mechanism& in_space) {
  const CoordinateBasis motions = motion_basis(mechanism.geometry, OrderChoice::minimal);
  const Elimination velocity(velocity_system(mechanism.topology, mechanism.geometry, motions), {});
  const int l = mechanism.graph.circuit_count();
  MobilityCounts counts;
  counts.evidence = velocity.evidence();
  counts.minimal.motions = motion_counts(mechanism, motions.order(), velocity.rank());
  if (mechanism.space == Space::planar || is_planar(motions)) {
    counts.planar = SideCounts{.motions = in_order(counts.minimal.motions, 3, l), .actions = {}};
  }
  counts.spatial.motions =
      in_space.topology.freedom_count() == mechanism.topology.freedom_count()
          ? in_order(counts.minimal.motions, 6, l)
          : count_motions_in(in_space, motion_basis(in_space.geometry, OrderChoice::spatial));
  return counts;
}

void count_actions(const Mechanism& mechanism, const Mechanism& in_space, MobilityCounts& counts) {
  const CoordinateBasis actions = action_basis(mechanism.geometry, OrderChoice::minimal);
  counts.minimal.actions = count_actions_in(mechanism, actions);
  if (counts.planar && (is_planar_static(mechanism) || is_planar(actions))) {
    counts.planar->actions =
        count_actions_in(mechanism, action_basis(mechanism.geometry, OrderChoice::planar));
  }
  counts.spatial.actions =
      count_actions_in(in_space, action_basis(in_space.geometry, OrderChoice::spatial));
}

}  // namespace kinestat
