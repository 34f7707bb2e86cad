#include "studies/sensitivity/equation_rounding.hpp"

#include <algorithm>
#include <iterator>

#include "network/bases.hpp"
#include "network/node_system.hpp"
#include "studies/sensitivity/internal/case_equations.hpp"

namespace kinestat {

namespace {

// Loads and the friction on both bodies.
std::vector<BodyWrench> outside_wrenches(const Mechanism& mechanism,
                                         const Case& which,
                                         const StaticSolution& action) {
  std::vector<BodyWrench> result = wrenches_of(which.loads);
  for (const FrictionAction& one : action.friction) {
    const CouplingTopology& coupling = mechanism.topology.coupling(one.coupling);
    const BodyPair bodies =
        one.between.value_or(BodyPair{.tail = coupling.tail, .head = coupling.head});
    result.push_back({.body = bodies.head, .wrench = one.wrench});
    result.push_back({.body = bodies.tail, .wrench = -1.0 * one.wrench});
  }
  return result;
}

// Behind a slipping cable a tension is a share of the one ahead, which may be 1e14 times as large:
// as a difference to its friction it would pass for rounding.
bool has_slipping_cable(const Mechanism& mechanism, const StaticSolution& action) {
  return std::ranges::any_of(mechanism.contacts, [&](const CableContact& contact) {
    return contact.slips &&
           std::ranges::find(action.friction, *contact.slips, &FrictionAction::coupling) !=
               action.friction.end();
  });
}

}  // namespace

std::vector<double> rate_rounding(std::span<const std::size_t> wanted,
                                  const Mechanism& mechanism,
                                  const Case& which,
                                  const KinematicSolution& motion) {
  const CoordinateBasis basis = motion_basis(mechanism.geometry, mechanism.kinematic_order);
  return motion_equations(mechanism, which, basis).bounds(wanted, motion.rates, {});
}

std::vector<double> action_rounding(std::span<const std::size_t> wanted,
                                    const Mechanism& mechanism,
                                    const Case& which,
                                    const StaticSolution& action) {
  if (has_slipping_cable(mechanism, action)) {
    return std::vector<double>(wanted.size(), 0.0);
  }
  const std::vector<BodyWrench> outside = outside_wrenches(mechanism, which, action);
  const CoordinateBasis basis = action_basis(mechanism.geometry, mechanism.static_order, outside);
  std::vector<double> magnitudes;
  std::ranges::transform(action.magnitudes,
                         std::back_inserter(magnitudes),
                         [](const std::optional<double>& one) { return one.value_or(0.0); });
  return action_equations(mechanism, which, basis)
      .bounds(wanted, magnitudes, load_vector(mechanism.topology.body_count(), basis, outside));
}

}  // namespace kinestat
