#include "studies/simulation/simulation.hpp"

#include <algorithm>

#include "core/index.hpp"
#include "studies/simulation/internal/simulator.hpp"

namespace kinestat {

bool has_any(const SimulationSolution& solution,
             std::vector<std::optional<double>> SimulationRow::*list,
             int freedom) {
  return std::ranges::any_of(solution.rows, [&](const SimulationRow& row) {
    return (row.*list)[at(freedom)].has_value();
  });
}

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
