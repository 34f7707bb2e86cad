#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

#include "files/load_file.hpp"
#include "math/elimination/exact_elimination.hpp"
#include "math/elimination/refined_solve.hpp"
#include "network/node_system.hpp"
#include "property/library_files.hpp"
#include "property/network_case.hpp"

namespace kinestat {
namespace {

class LibraryAccuracy : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    SourceFile source;
    Diagnostics found;
    std::optional<Loaded> loaded = load((kLibraryFolder / GetParam()).string(), {}, source, found);
    ASSERT_TRUE(loaded.has_value());
    network_.emplace(make_network_case(std::move(loaded->mechanism)));
  }

  std::optional<NetworkCase> network_;
};

INSTANTIATE_TEST_SUITE_P(File,
                         LibraryAccuracy,
                         ::testing::ValuesIn(list_library_files()),
                         library_test_name);

// The equations with a pivot and the columns that they determine, of these very doubles.
ExactMatrix regular_part(const SparseMatrix& matrix, const Elimination& factors) {
  const std::vector<int> rows = factors.pivot_rows();
  ExactMatrix result = exact_matrix(matrix);
  std::erase_if(result.entries, [&](const ExactEntry& entry) {
    return !std::ranges::binary_search(rows, entry.row) ||
           std::ranges::binary_search(factors.free_columns(), entry.column);
  });
  return result;
}

// Holds the bounds after no, one and two steps against the exact solution.
void expect_bounds(const SparseMatrix& matrix,
                   const std::vector<int>& columns,
                   const std::vector<double>& known) {
  const Elimination factors(matrix, columns);
  const ExactElimination exact(regular_part(matrix, factors), columns);
  const std::vector<Rational> values(known.begin(), known.end());
  const std::vector<Rational> expected = exact.solve(values, {}).x;
  ASSERT_EQ(exact.rank(), static_cast<int>(factors.pivot_rows().size()));
  RefinedSolve solve(factors, known, {});
  for (int step = 0; step < 3; ++step) {
    SCOPED_TRACE(step);
    const std::optional<VecX> bound = solve.error_bound();
    ASSERT_TRUE(bound.has_value());
    const std::vector<DoubleDouble> x = solve.x();
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Rational error = expected[i] - Rational(x[i].high) - Rational(x[i].low);
      ASSERT_LE(abs(error), Rational((*bound)[static_cast<Eigen::Index>(i)])) << "unknown " << i;
    }
    solve.refine();
  }
}

TEST_P(LibraryAccuracy, OfVelocitiesHasBoundsThatCoverTheError) {
  Random random(1);
  const Topology& topology = network_->mechanism.topology;
  std::vector<int> columns;
  std::vector<double> known;
  for (const Primary& primary : choose_motions(*network_, random)) {
    columns.push_back(velocity_column(topology, network_->twist_basis, primary.index));
    known.push_back(primary.value / rate_unit(topology, network_->twist_basis, primary.index));
  }

  expect_bounds(velocity_system(topology, network_->mechanism.geometry, network_->twist_basis),
                columns,
                known);
}

TEST_P(LibraryAccuracy, OfActionsHasBoundsThatCoverTheError) {
  Random random(1);
  const Topology& topology = network_->mechanism.topology;
  std::vector<int> columns;
  std::vector<double> known;
  for (const Primary& primary : choose_actions(*network_, random)) {
    columns.push_back(primary.index);
    known.push_back(primary.value / action_unit(topology, network_->wrench_basis, primary.index));
  }

  expect_bounds(action_system(topology, network_->mechanism.geometry, network_->wrench_basis),
                columns,
                known);
}

}  // namespace
}  // namespace kinestat
