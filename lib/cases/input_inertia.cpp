#include "cases/input_inertia.hpp"

#include <utility>

#include "core/index.hpp"
#include "dynamics/equivalent_inertia.hpp"
#include "kinematics/velocity.hpp"
#include "network/bases.hpp"

namespace kinestat {

namespace {

// The drives of a case whose only drive rests, with this at unit speed: the inertia is a ratio of
// energies, the same at any speed. Empty of other cases.
std::vector<Primary> drives_off_rest(const Case& which) {
  std::vector<Primary> drives = which.motions;
  Primary* resting = nullptr;
  for (Primary& drive : drives) {
    if (drive.value != 0.0 || (!drive.is_assumed && std::exchange(resting, &drive) != nullptr)) {
      return {};
    }
  }
  if (resting == nullptr) {
    return {};
  }
  resting->value = 1.0;
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
  const std::vector<Primary> drives = drives_off_rest(one.which);
  if (drives.empty()) {
    return equivalent_inertias(mechanism, *one.motion, *freedom);
  }
  const CoordinateBasis basis = motion_basis(mechanism.geometry, mechanism.kinematic_order);
  return equivalent_inertias(mechanism, solve_velocity(mechanism, basis, drives), *freedom);
}

}  // namespace kinestat
