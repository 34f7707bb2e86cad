#include "studies/mobility/mobility.hpp"

#include "network/bases.hpp"

namespace kinestat {

namespace {

// More than an engineer would compare.
constexpr int kMostRepairs = 5;

Redundancies in_order(const Mechanism& mechanism, OrderChoice order, const MotionCounts& counts) {
  return find_redundancies(
      mechanism, motion_basis(mechanism.geometry, order), counts.net_constraint);
}

}  // namespace

ExactMobility find_exact_mobility(const Mechanism& mechanism, const Mechanism& in_space) {
  ExactMobility exact;
  exact.counts = count_motions(mechanism, in_space);
  count_actions(mechanism, in_space, exact.counts);
  exact.motions =
      find_motion_space(mechanism, motion_basis(mechanism.geometry, OrderChoice::minimal));
  exact.spatial = in_order(in_space, OrderChoice::spatial, exact.counts.spatial.motions);
  if (exact.counts.planar) {
    exact.planar = in_order(mechanism, OrderChoice::planar, exact.counts.planar->motions);
  }
  exact.minimal = in_order(mechanism, OrderChoice::minimal, exact.counts.minimal.motions);
  exact.repairs = find_repairs(in_space, exact.counts.spatial.motions, exact.spatial, kMostRepairs);
  return exact;
}

}  // namespace kinestat
