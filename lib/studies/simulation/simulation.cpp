#include "studies/simulation/simulation.hpp"

#include "studies/simulation/internal/simulator.hpp"

namespace kinestat {

SimulationSolution solve_simulation(const Mechanism& mechanism,
                                    const MotionNetwork& network,
                                    std::span<const DrawnCoupling> drawn,
                                    const SimulationPlan& plan,
                                    const Configuration& start,
                                    const std::vector<int>& coordinates,
                                    const VecX& rates) {
  return Simulator(mechanism, network, drawn, plan).run(start, coordinates, rates);
}

}  // namespace kinestat
