#include "statics/one_sided_action.hpp"

#include <algorithm>
#include <iterator>

#include "core/tolerance.hpp"
#include "kinematics/bounded_motion.hpp"
#include "statics/coupling_wrenches.hpp"

namespace kinestat {

namespace {

// What has no value is not known to be negative, nor is what its bound does not tell from zero.
std::vector<int> find_negative(const StaticSolution& solution, const std::vector<int>& actions) {
  std::vector<int> negative;
  if (solution.magnitudes.empty()) {
    return negative;
  }
  std::ranges::copy_if(actions, std::back_inserter(negative), [&](int a) {
    return solution.magnitudes[static_cast<std::size_t>(a)].has_value() &&
           bounded_action(solution, a).zeroed() < 0.0;
  });
  return negative;
}

}  // namespace

std::vector<CouplingId> find_pushed_segments(const Mechanism& mechanism,
                                             const StaticSolution& solution) {
  std::vector<CouplingId> pushed;
  for (const int a : find_negative(solution, find_tensions(mechanism.topology))) {
    pushed.push_back(mechanism.topology.actions[static_cast<std::size_t>(a)].coupling);
  }
  return pushed;
}

std::vector<int> find_pulling_contacts(const Mechanism& mechanism, const StaticSolution& solution) {
  return find_negative(solution, find_contact_forces(mechanism.topology));
}

std::vector<WrongFreewheel> find_wrong_freewheels(const Mechanism& mechanism,
                                                  const std::optional<KinematicSolution>& motion,
                                                  const std::optional<StaticSolution>& action) {
  const auto torque_of = [&](const Freewheel& one) {
    const bool is_known = action && !action->magnitudes.empty() &&
                          action->magnitudes[static_cast<std::size_t>(one.action)].has_value();
    return is_known ? bounded_action(*action, one.action).zeroed() : 0.0;
  };
  const auto slip_of = [&](const Freewheel& one) {
    const bool is_known = motion && !motion->rates.empty() && motion->knows_rate(one.freedom);
    return is_known ? bounded_rate(*motion, one.freedom).zeroed() : 0.0;
  };
  std::vector<WrongFreewheel> wrong;
  for (const Freewheel& one : mechanism.freewheels) {
    const double torque = torque_of(one);
    const double slip = slip_of(one);
    if (const auto fault = fault_of(one, torque, slip)) {
      wrong.push_back({.coupling = one.coupling,
                       .fault = *fault,
                       .value = *fault == FreewheelFault::overruns ? torque : slip});
    }
  }
  return wrong;
}

bool is_one_sided(const VecX& actions, const Topology& topology) {
  const double rounding = kConsistency * actions.cwiseAbs().maxCoeff();
  const auto holds = [&](int a) { return actions[a] >= -rounding; };
  return std::ranges::all_of(find_tensions(topology), holds) &&
         std::ranges::all_of(find_contact_forces(topology), holds);
}

}  // namespace kinestat
