#include "network/exact_input_system.hpp"

#include "core/contract.hpp"
#include "graph/structural_rank.hpp"
#include "network/node_layout.hpp"

namespace kinestat {

namespace {

// Adds factor · (the screw's coordinates in the basis) as a column piece that begins at row
// `first`.
void add_screw(const ExactInputScrew& screw,
               const CoordinateBasis& basis,
               double factor,
               int first,
               int column,
               ExactInputMatrix& to) {
  for (int i = 0; i < basis.order(); ++i) {
    const int c = basis.coordinates[static_cast<std::size_t>(i)];
    const ExactInput& coordinate = screw[static_cast<std::size_t>(c)];
    if (!is_zero(coordinate)) {
      to.entries.push_back({.row = first + i,
                            .column = column,
                            .value = ExactInput(factor / basis.unit[c]) * coordinate});
    }
  }
}

template <class Entry>
int rank_of_pattern(const std::vector<Entry>& entries, int rows, int columns) {
  EntryPattern pattern(static_cast<std::size_t>(rows));
  for (const Entry& entry : entries) {
    pattern[static_cast<std::size_t>(entry.row)].push_back(entry.column);
  }
  return structural_rank(pattern, columns);
}

}  // namespace

ExactInputMatrix exact_input_velocity_system(const Topology& topology,
                                             const std::vector<ExactInputScrew>& motions,
                                             const CoordinateBasis& basis) {
  KINESTAT_EXPECTS(basis.is_made_of_coordinates());
  const SystemSize size = velocity_system_size(topology, basis);
  ExactInputMatrix system{.rows = size.rows, .columns = size.columns, .entries = {}};
  lay_velocity_system(
      topology,
      basis,
      [&](int row, int column, double value) {
        system.entries.push_back({.row = row, .column = column, .value = ExactInput(value)});
      },
      [&](int f, int first, int column, double factor) {
        add_screw(motions[static_cast<std::size_t>(f)], basis, factor, first, column, system);
      });
  return system;
}

ExactInputMatrix exact_input_action_system(const Topology& topology,
                                           const std::vector<ExactInputScrew>& actions,
                                           const CoordinateBasis& basis) {
  KINESTAT_EXPECTS(basis.is_made_of_coordinates());
  const SystemSize size = action_system_size(topology, basis);
  ExactInputMatrix system{.rows = size.rows, .columns = size.columns, .entries = {}};
  lay_action_system(topology, basis, [&](int a, int first, int column, double factor) {
    add_screw(actions[static_cast<std::size_t>(a)], basis, factor, first, column, system);
  });
  return system;
}

std::vector<ExactInput> exact_input_load_vector(int body_count,
                                                const CoordinateBasis& basis,
                                                std::span<const Load> loads,
                                                const std::vector<ExactInputScrew>& wrenches) {
  KINESTAT_EXPECTS(basis.is_made_of_coordinates() && loads.size() == wrenches.size());
  const auto order = static_cast<std::size_t>(basis.order());
  std::vector<ExactInput> right(order * static_cast<std::size_t>(body_count - 1));
  for (std::size_t l = 0; l < loads.size(); ++l) {
    const int body = loads[l].acts.body.value;
    for (std::size_t i = 0; body > 0 && i < order; ++i) {
      const int c = basis.coordinates[i];
      ExactInput& sum = right[order * static_cast<std::size_t>(body - 1) + i];
      sum = sum - ExactInput(1.0 / basis.unit[c]) * wrenches[l][static_cast<std::size_t>(c)];
    }
  }
  return right;
}

int largest_rank(const ExactInputMatrix& matrix) {
  return rank_of_pattern(matrix.entries, matrix.rows, matrix.columns);
}

int largest_rank(const SparseMatrix& matrix) {
  return rank_of_pattern(matrix.entries, matrix.rows, matrix.columns);
}

}  // namespace kinestat
