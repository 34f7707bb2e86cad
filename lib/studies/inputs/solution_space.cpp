#include "studies/inputs/solution_space.hpp"

#include <utility>

#include "core/rounding.hpp"
#include "math/elimination/data_zero.hpp"
#include "network/node_system.hpp"

namespace kinestat {

namespace {

SolutionSpace read_space(SparseMatrix system,
                         int order,
                         int first_column,
                         std::vector<double> units) {
  const Elimination elimination(std::move(system), {});
  const std::vector<VecX> vectors = settled_null_vectors(
      elimination, {.rows = order, .first_column = first_column, .share = kDataRounding});
  SolutionSpace space;
  space.evidence = elimination.evidence();
  const auto rows = static_cast<Eigen::Index>(units.size());
  space.basis.resize(rows, static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t j = 0; j < vectors.size(); ++j) {
    space.basis.col(static_cast<Eigen::Index>(j)) = vectors[j].segment(first_column, rows);
  }
  space.units = std::move(units);
  return space;
}

}  // namespace

SolutionSpace motion_space(const Mechanism& mechanism, const CoordinateBasis& coordinates) {
  const Topology& topology = mechanism.topology;
  return read_space(velocity_system(topology, mechanism.geometry, coordinates),
                    coordinates.order(),
                    velocity_column(topology, coordinates, 0),
                    rate_units(topology, coordinates));
}

SolutionSpace action_space(const Mechanism& mechanism, const CoordinateBasis& coordinates) {
  const Topology& topology = mechanism.topology;
  return read_space(action_system(topology, mechanism.geometry, coordinates),
                    coordinates.order(),
                    0,
                    action_units(topology, coordinates));
}

}  // namespace kinestat
