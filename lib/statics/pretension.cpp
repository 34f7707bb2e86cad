#include "statics/pretension.hpp"

#include <algorithm>
#include <cmath>

#include "core/tolerance.hpp"
#include "statics/equilibrium.hpp"

namespace kinestat {

namespace {

// The tensions of the segments, as the actions that they are.
std::vector<int> find_tensions(const Topology& topology) {
  std::vector<int> tensions;
  for (const CouplingTopology& coupling : topology.couplings) {
    if (coupling.type == CouplingType::cable && coupling.action_count > 0) {
      tensions.push_back(coupling.first_action);
    }
  }
  return tensions;
}

// Forces below this are none.
double least_force(const Mechanism& mechanism, const StaticSolution& solution) {
  double largest = 0.0;
  for (std::size_t a = 0; a < solution.magnitudes.size(); ++a) {
    const bool is_force = !mechanism.topology.actions[a].is_couple;
    largest = std::max(largest, is_force ? std::abs(solution.magnitudes[a].value_or(0.0)) : 0.0);
  }
  return kNoReaction * largest;
}

VecX scales_of(const Mechanism& mechanism) {
  VecX scales(mechanism.topology.action_count());
  for (Eigen::Index a = 0; a < scales.size(); ++a) {
    const bool is_couple = mechanism.topology.actions[static_cast<std::size_t>(a)].is_couple;
    scales[a] = is_couple ? mechanism.geometry.length : 1.0;
  }
  return scales;
}

// The self-stresses that no actuator takes part in.
std::vector<SelfStress> passive_stresses(const Mechanism& mechanism, const CoordinateBasis& basis) {
  std::vector<int> driving;
  for (const ActuatorTopology& actuator : mechanism.topology.actuators) {
    driving.push_back(actuator.action);
  }
  const Equilibrium equilibrium(mechanism, basis, std::move(driving));
  return list_self_stresses(equilibrium.self_stresses(), scales_of(mechanism));
}

// In the sense in which it pulls; empty if it pushes on a segment too, or pulls on none.
std::optional<VecX> pulling(const SelfStress& stress,
                            const std::vector<int>& tensions,
                            Eigen::Index count) {
  VecX vector = VecX::Zero(count);
  for (const DependenceTerm& term : stress.terms) {
    vector[term.index] = term.coefficient;
  }
  double low = 0.0;
  double high = 0.0;
  for (const int a : tensions) {
    low = std::min(low, vector[a]);
    high = std::max(high, vector[a]);
  }
  if ((low < 0.0) == (high > 0.0)) {
    return std::nullopt;
  }
  return low < 0.0 ? VecX(-vector) : vector;
}

}  // namespace

std::vector<CouplingId> find_pushed_segments(const Mechanism& mechanism,
                                             const StaticSolution& solution) {
  std::vector<CouplingId> pushed;
  if (solution.magnitudes.empty()) {
    return pushed;
  }
  const double least = least_force(mechanism, solution);
  for (const int a : find_tensions(mechanism.topology)) {
    if (solution.magnitudes[static_cast<std::size_t>(a)].value_or(0.0) < -least) {
      pushed.push_back(mechanism.topology.actions[static_cast<std::size_t>(a)].coupling);
    }
  }
  return pushed;
}

std::optional<VecX> find_pretension(const Mechanism& mechanism,
                                    const CoordinateBasis& basis,
                                    const StaticSolution& solution) {
  const std::vector<int> tensions = find_tensions(mechanism.topology);
  VecX forces(mechanism.topology.action_count());
  for (const int a : tensions) {
    const std::optional<double> force = solution.magnitudes[static_cast<std::size_t>(a)];
    if (!force) {
      return std::nullopt;
    }
    forces[a] = *force;
  }
  VecX sum = VecX::Zero(forces.size());
  for (const SelfStress& stress : passive_stresses(mechanism, basis)) {
    const std::optional<VecX> vector = pulling(stress, tensions, forces.size());
    double multiple = 0.0;
    for (const int a : vector ? tensions : std::vector<int>{}) {
      if ((*vector)[a] > 0.0) {
        multiple = std::max(multiple, -(forces[a] + sum[a]) / (*vector)[a]);
      }
    }
    if (multiple > 0.0) {
      sum += multiple * *vector;
    }
  }
  const double least = least_force(mechanism, solution);
  const bool is_taut =
      std::ranges::all_of(tensions, [&](int a) { return forces[a] + sum[a] >= -least; });
  return is_taut ? std::optional(sum) : std::nullopt;
}

}  // namespace kinestat
