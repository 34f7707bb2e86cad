#include "statics/one_sided_action.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// Forces below this are none.
double rounding_force(const Mechanism& mechanism, const StaticSolution& solution) {
  double largest = 0.0;
  for (std::size_t a = 0; a < solution.magnitudes.size(); ++a) {
    const bool is_force = !mechanism.topology.actions[a].is_couple;
    largest = std::max(largest, is_force ? std::abs(solution.magnitudes[a].value_or(0.0)) : 0.0);
  }
  return kNoReaction * largest;
}

// What has no value is not known to be negative.
std::vector<int> find_negative(const Mechanism& mechanism,
                               const StaticSolution& solution,
                               const std::vector<int>& actions) {
  std::vector<int> negative;
  if (solution.magnitudes.empty() || actions.empty()) {
    return negative;
  }
  const double rounding = rounding_force(mechanism, solution);
  for (const int a : actions) {
    if (solution.magnitudes[static_cast<std::size_t>(a)].value_or(0.0) < -rounding) {
      negative.push_back(a);
    }
  }
  return negative;
}

bool only_pushes(CouplingType type) {
  return type == CouplingType::point_contact || type == CouplingType::cam ||
         type == CouplingType::line_contact;
}

}  // namespace

std::vector<int> find_tensions(const Topology& topology) {
  std::vector<int> tensions;
  for (const CouplingTopology& coupling : topology.couplings) {
    if (coupling.bears_tension()) {
      tensions.push_back(coupling.first_action);
    }
  }
  return tensions;
}

std::vector<int> find_contact_forces(const Topology& topology) {
  std::vector<int> forces;
  for (std::size_t a = 0; a < topology.actions.size(); ++a) {
    const ActionLabel& label = topology.actions[a];
    if (only_pushes(topology.coupling(label.coupling).type) && !label.is_couple &&
        label.actuator < 0) {
      forces.push_back(static_cast<int>(a));
    }
  }
  return forces;
}

std::vector<CouplingId> find_pushed_segments(const Mechanism& mechanism,
                                             const StaticSolution& solution) {
  std::vector<CouplingId> pushed;
  for (const int a : find_negative(mechanism, solution, find_tensions(mechanism.topology))) {
    pushed.push_back(mechanism.topology.actions[static_cast<std::size_t>(a)].coupling);
  }
  return pushed;
}

std::vector<int> find_pulling_contacts(const Mechanism& mechanism, const StaticSolution& solution) {
  return find_negative(mechanism, solution, find_contact_forces(mechanism.topology));
}

}  // namespace kinestat
