#include "studies/mobility/mobility_counts.hpp"

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

// Wherever the origin is.
template <class Screw>
bool are_held_by(const CoordinateBasis& basis, const std::vector<Screw>& screws) {
  return std::ranges::all_of(screws,
                             [&](const Screw& screw) { return basis.holds(screw.coordinates()); });
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
  const Geometry& geometry = mechanism.geometry;
  if (mechanism.space == Space::planar ||
      are_held_by(motion_basis(geometry, OrderChoice::planar), geometry.motions)) {
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
  const CoordinateBasis planar = action_basis(mechanism.geometry, OrderChoice::planar);
  if (counts.planar &&
      (is_planar_static(mechanism) || are_held_by(planar, mechanism.geometry.actions))) {
    counts.planar->actions = count_actions_in(mechanism, planar);
  }
  counts.spatial.actions =
      count_actions_in(in_space, action_basis(in_space.geometry, OrderChoice::spatial));
}

}  // namespace kinestat
