#include "studies/inputs/solution_space.hpp"

#include <cmath>
#include <utility>

#include "core/tolerance.hpp"
#include "math/elimination/elimination.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

// What is mere rounding beside the largest magnitude of its solution is zero.
SolutionSpace read_space(SparseMatrix system, int first_column, std::vector<double> units) {
  const Elimination elimination(std::move(system), {});
  const std::vector<VecX> vectors = elimination.null_vectors();
  SolutionSpace space;
  space.evidence = elimination.evidence();
  const auto rows = static_cast<Eigen::Index>(units.size());
  space.basis.resize(rows, static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t j = 0; j < vectors.size(); ++j) {
    const auto part = vectors[j].segment(first_column, rows);
    const double largest = rows == 0 ? 0.0 : part.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < rows; ++i) {
      const bool counts = std::abs(part[i]) > kRankZero * largest;
      space.basis(i, static_cast<Eigen::Index>(j)) = counts ? part[i] : 0.0;
    }
  }
  space.units = std::move(units);
  return space;
}

}  // namespace

SolutionSpace motion_space(const Mechanism& mechanism, const CoordinateBasis& coordinates) {
  const Topology& topology = mechanism.topology;
  std::vector<double> units;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    units.push_back(rate_unit(topology, coordinates, f));
  }
  return read_space(velocity_system(topology, mechanism.geometry, coordinates),
                    velocity_column(topology, coordinates, 0),
                    std::move(units));
}

SolutionSpace action_space(const Mechanism& mechanism, const CoordinateBasis& coordinates) {
  const Topology& topology = mechanism.topology;
  std::vector<double> units;
  for (int a = 0; a < topology.action_count(); ++a) {
    units.push_back(action_unit(topology, coordinates, a));
  }
  return read_space(action_system(topology, mechanism.geometry, coordinates), 0, std::move(units));
}

}  // namespace kinestat
