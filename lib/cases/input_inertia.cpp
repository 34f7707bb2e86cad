#include "cases/input_inertia.hpp"

#include <algorithm>

#include "core/index.hpp"
#include "dynamics/equivalent_inertia.hpp"
#include "kinematics/velocity.hpp"
#include "network/bases.hpp"

namespace kinestat {

namespace {

// The drives of a case in which all rest, with the input, or the only one, at unit speed: the
// inertia is a ratio of energies, the same at any speed. Empty of other cases.
std::vector<Primary> drives_off_rest(const Case& which, int input) {
  std::vector<Primary> drives = which.motions;
  const auto is_drive = [](const Primary& one) { return !one.is_assumed; };
  const auto of_input = std::ranges::find(drives, input, &Primary::index);
  const auto first = std::ranges::find_if(drives, is_drive);
  const bool is_alone = std::ranges::count_if(drives, is_drive) == 1;
  const auto moved = of_input != drives.end() ? of_input : is_alone ? first : drives.end();
  if (moved == drives.end() ||
      std::ranges::any_of(drives, [](const Primary& one) { return one.value != 0.0; })) {
    return {};
  }
  moved->value = 1.0;
  return drives;
}

}  // namespace

std::optional<int> only_input_freedom(const Mechanism& mechanism, const Case& which) {
  return which.inputs.size() == 1
             ? std::optional(mechanism.topology.actuators[at(which.inputs.front())].freedom)
             : std::nullopt;
}

std::optional<std::vector<double>> input_inertias(const Mechanism& mechanism,
                                                  const CaseAnalysis& one) {
  const std::optional<int> freedom = only_input_freedom(mechanism, one.which);
  if (!freedom || !one.motion) {
    return std::nullopt;
  }
  const std::vector<Primary> drives = drives_off_rest(one.which, *freedom);
  if (drives.empty()) {
    return equivalent_inertias(mechanism, *one.motion, *freedom);
  }
  const CoordinateBasis basis = motion_basis(mechanism.geometry, mechanism.kinematic_order);
  return equivalent_inertias(mechanism, solve_velocity(mechanism, basis, drives), *freedom);
}

}  // namespace kinestat
