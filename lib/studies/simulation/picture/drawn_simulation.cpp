#include "studies/simulation/picture/drawn_simulation.hpp"

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

}  // namespace kinestat
