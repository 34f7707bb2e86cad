#include "studies/simulation/picture/drawn_simulation.hpp"

#include <algorithm>

#include "studies/motion/picture/drawn_actions_maker.hpp"
#include "studies/motion/picture/drawn_motion_maker.hpp"

namespace kinestat {

DrawnMotion make_drawn_simulation(const FoundSimulation& simulation,
                                  const std::vector<std::size_t>& shown) {
  DrawnMotion result;
  const std::vector<SimulationRow>& rows = simulation.solution.rows;
  Mechanism moved = simulation.mechanism;
  for (const std::size_t row : shown) {
    result.shares.push_back(rows[row].time / simulation.plan.duration);
    result.positions.push_back(drawn_position(simulation.network,
                                              simulation.drawn,
                                              rows[row].configuration,
                                              simulation.mechanism,
                                              moved));
  }
  return result;
}

DrawnActions make_drawn_actions(const FoundSimulation& simulation,
                                const std::vector<std::size_t>& shown,
                                const DrawnMotion& drawn) {
  std::vector<std::vector<std::optional<Vec3>>> forces;
  for (const std::size_t row : shown) {
    forces.push_back(simulation.solution.rows[row].reactions);
  }
  const bool has_any = std::ranges::any_of(forces, [](const auto& one) { return !one.empty(); });
  return has_any ? DrawnActions{.arrows = reaction_arrows(simulation.mechanism, forces, drawn),
                                .doubts = std::vector<std::string>(shown.size())}
                 : DrawnActions{};
}

}  // namespace kinestat
