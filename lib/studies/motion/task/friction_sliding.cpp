#include "studies/motion/task/friction_sliding.hpp"

#include <algorithm>
#include <optional>

#include "couplings/kinds.hpp"

namespace kinestat {

Vec3 sliding_of(const Topology& topology,
                CouplingId coupling,
                std::span<const std::optional<double>> rates) {
  const CouplingTopology& one = topology.coupling(coupling);
  const bool has_axis = kind_of(one.type).friction != FrictionKind::sliding;
  Vec3 result = Vec3::Zero();
  Eigen::Index count = 0;
  for (int i = 0; i < one.freedom_count && count < result.size(); ++i) {
    const auto f = static_cast<std::size_t>(one.first_freedom + i);
    if (has_axis || !topology.freedoms[f].is_rotation) {
      result[count++] = rates[f].value_or(0.0);
    }
  }
  return result;
}

std::vector<Vec3> sliding_speeds(const Mechanism& mechanism, const MotionPosition& position) {
  std::vector<std::optional<double>> rates;
  if (position.solved && position.solved->motion) {
    const std::vector<double>& known = position.solved->motion->rates;
    rates.assign(known.begin(), known.end());
  } else if (has_motion(position)) {
    rates = position.state.rates;
  }
  std::vector<Vec3> speeds;
  for (std::size_t f = 0; !rates.empty() && f < mechanism.frictions.size(); ++f) {
    speeds.push_back(sliding_of(mechanism.topology, mechanism.frictions[f].coupling, rates));
  }
  return speeds;
}

FrictionSliding sliding_at(const Mechanism& mechanism,
                           const MotionPlan& plan,
                           const MotionPosition& position) {
  FrictionSliding sliding;
  if (!position.solved || !position.solved->motion || position.solved->motion->rates.empty()) {
    return sliding;
  }
  sliding.stands = has_drive_at_rest(plan, position);
  sliding.rates = sliding_speeds(mechanism, position);
  const std::optional<StaticSolution>& action = position.solved->action;
  for (std::size_t f = 0; action && f < sliding.rates.size(); ++f) {
    if (std::ranges::find(action->at_rest, mechanism.frictions[f].coupling) !=
        action->at_rest.end()) {
      sliding.rates[f] = Vec3::Zero();
    }
  }
  return sliding;
}

}  // namespace kinestat
