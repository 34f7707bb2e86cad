#include "network/node_system.hpp"

#include <cmath>

#include "core/tolerance.hpp"
#include "network/node_layout.hpp"

namespace kinestat {

namespace {

// Of a coordinate of a load before loads are summed: of its number as typed, its unit, its place,
// their product and the direction of the basis.
constexpr double kRoundingsOfLoad = 4.0;

// Adds factor · (the screw's coordinates in the basis) as a column piece that begins at `first`.
void add_screw(const Vec6& screw,
               const CoordinateBasis& basis,
               double factor,
               int first,
               int column,
               SparseMatrix& to) {
  if (basis.is_made_of_coordinates()) {
    for (int i = 0; i < basis.order(); ++i) {
      const int c = basis.coordinates[static_cast<std::size_t>(i)];
      to.add(first + i, column, factor * screw[c] / basis.unit[c]);
    }
    return;
  }
  const VecX coordinates = basis.coordinates_of(screw);
  for (int i = 0; i < basis.order(); ++i) {
    to.add(first + i, column, factor * coordinates[i]);
  }
}

SparseMatrix empty_system(const SystemSize& size) {
  return {.rows = size.rows, .columns = size.columns, .entries = {}};
}

}  // namespace

SparseMatrix velocity_system(const Topology& topology,
                             const Geometry& geometry,
                             const CoordinateBasis& basis) {
  SparseMatrix system = empty_system(velocity_system_size(topology, basis));
  lay_velocity_system(
      topology,
      basis,
      [&](int row, int column, double value) { system.add(row, column, value); },
      [&](int f, int first, int column, double factor) {
        const Vec6 screw = geometry.motions[static_cast<std::size_t>(f)].coordinates();
        add_screw(screw, basis, factor, first, column, system);
      });
  return system;
}

int velocity_column(const Topology& topology, const CoordinateBasis& basis, int freedom) {
  return basis.order() * (topology.body_count() - 1) + freedom;
}

double rate_unit(const Topology& topology, const CoordinateBasis& basis, int freedom) {
  const bool turns = topology.freedoms[static_cast<std::size_t>(freedom)].is_rotation;
  return turns ? 1.0 : basis.length_unit(ScrewKind::twist);
}

double action_unit(const Topology& topology, const CoordinateBasis& basis, int action) {
  const bool turns = topology.actions[static_cast<std::size_t>(action)].is_couple;
  return turns ? basis.length_unit(ScrewKind::wrench) : 1.0;
}

std::vector<double> rate_units(const Topology& topology, const CoordinateBasis& basis) {
  std::vector<double> units;
  for (int f = 0; f < topology.freedom_count(); ++f) {
    units.push_back(rate_unit(topology, basis, f));
  }
  return units;
}

std::vector<double> action_units(const Topology& topology, const CoordinateBasis& basis) {
  std::vector<double> units;
  for (int a = 0; a < topology.action_count(); ++a) {
    units.push_back(action_unit(topology, basis, a));
  }
  return units;
}

Twist body_twist(const VecX& solution, const CoordinateBasis& basis, BodyId body) {
  if (body.value == 0 || basis.order() == 0) {
    return {};
  }
  const Eigen::Index first = basis.order() * (body.value - 1);
  return Twist::from_coordinates(basis.screw_of(solution.segment(first, basis.order())));
}

SparseMatrix action_system(const Topology& topology,
                           const Geometry& geometry,
                           const CoordinateBasis& basis) {
  SparseMatrix system = empty_system(action_system_size(topology, basis));
  lay_action_system(topology, basis, [&](int a, int first, int column, double factor) {
    const Vec6 screw = geometry.actions[static_cast<std::size_t>(a)].coordinates();
    add_screw(screw, basis, factor, first, column, system);
  });
  return system;
}

std::vector<double> load_vector(int body_count,
                                const CoordinateBasis& basis,
                                std::span<const BodyWrench> loads) {
  if (loads.empty()) {
    return {};
  }
  const int order = basis.order();
  std::vector<double> right(static_cast<std::size_t>(order * (body_count - 1)), 0.0);
  std::vector<double> terms = right;
  for (const BodyWrench& load : loads) {
    if (load.body.value > 0) {
      const VecX coordinates = basis.coordinates_of(load.wrench.coordinates());
      const auto first = static_cast<std::size_t>(order * (load.body.value - 1));
      for (int i = 0; i < order; ++i) {
        right[first + static_cast<std::size_t>(i)] -= coordinates[i];
        terms[first + static_cast<std::size_t>(i)] += std::abs(coordinates[i]);
      }
    }
  }
  const double share = (kRoundingsOfLoad + static_cast<double>(loads.size())) * kEpsilon;
  for (std::size_t r = 0; r < right.size(); ++r) {
    right[r] = std::abs(right[r]) <= share * terms[r] ? 0.0 : right[r];
  }
  return right;
}

}  // namespace kinestat
