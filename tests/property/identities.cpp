#include "property/identities.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "graph/cutsets.hpp"
#include "network/bases.hpp"
#include "network/node_system.hpp"
#include "support/near.hpp"

namespace kinestat {

namespace {

// Relative to the largest entry times the largest magnitude: a solution may be all zeros but for
// magnitudes that occur in no equation, such as the freedom of a bridge of the graph.
void expect_annulled(const MatX& N, const VecX& x) {
  if (N.rows() > 0) {
    const VecX sums = N * x;
    EXPECT_LE(size_of(sums), kAgreement * size_of(N) * size_of(x));
  }
}

// In units of the mechanism's length.
template <class Screw>
MatX columns_of(const std::vector<Screw>& screws,
                const CoordinateBasis& basis,
                int first,
                int count) {
  MatX columns(basis.order(), count);
  for (int i = 0; i < count; ++i) {
    const Screw& screw = screws[static_cast<std::size_t>(first + i)];
    columns.col(i) = basis.coordinates_of(screw.coordinates());
  }
  return columns;
}

}  // namespace

void expect_orthogonal_graph(const CouplingGraph& graph) {
  const MatXi product = circuit_matrix(cutset_matrix(graph)) * cutset_matrix(graph).transpose();

  EXPECT_TRUE(product.isZero());
  EXPECT_EQ(graph.cutset_count(), graph.graph.vertex_count - 1);
  EXPECT_EQ(graph.circuit_count(), graph.graph.edge_count() - graph.graph.vertex_count + 1);
}

void expect_reciprocal_couplings(const NetworkCase& network) {
  const Topology& topology = network.mechanism.topology;
  const Geometry& geometry = network.mechanism.geometry;
  for (const CouplingTopology& coupling : topology.couplings) {
    SCOPED_TRACE(coupling.name);
    const MatX freedoms = columns_of(
        geometry.motions, network.twist_basis, coupling.first_freedom, coupling.freedom_count);
    const MatX constraints = columns_of(geometry.actions,
                                        network.wrench_basis,
                                        coupling.first_action,
                                        passive_count(topology, coupling));
    const MatX work = constraints.transpose() * freedoms;

    EXPECT_EQ(find_rank(freedoms).rank, freedoms.cols());
    EXPECT_EQ(find_rank(constraints).rank, constraints.cols());
    EXPECT_TRUE(is_near(work, MatX::Zero(work.rows(), work.cols()), kTight));
  }
}

void expect_equal_ranks(const NetworkCase& network) {
  const Mechanism& mechanism = network.mechanism;
  const int body_rank = network.order() * (mechanism.topology.body_count() - 1);
  const Elimination velocity(
      velocity_system(mechanism.topology, mechanism.geometry, network.twist_basis), {});
  const Elimination action(
      action_system(mechanism.topology, mechanism.geometry, network.wrench_basis), {});

  EXPECT_EQ(velocity.rank(), body_rank + find_rank(network.M_N).rank);
  EXPECT_EQ(action.rank(), find_rank(network.A_N).rank);
}

void expect_complementary_counts(const NetworkCase& network) {
  const int order = network.order();
  const int F = static_cast<int>(network.M_N.cols());
  const int C = static_cast<int>(network.A_P.cols());
  const int k = network.mechanism.graph.cutset_count();
  const int l = network.mechanism.graph.circuit_count();
  const int m = find_rank(network.M_N).rank;
  const int a = find_rank(network.A_P).rank;

  EXPECT_EQ(F + C, order * network.mechanism.topology.coupling_count());
  EXPECT_EQ(F - m, order * k - a) << "F_N from both sides";
  EXPECT_EQ(C - a, order * l - m) << "C_N from both sides";
  EXPECT_EQ((F - m) - (C - a), F - order * l);
}

void expect_complementary_couplings(const RandomNetwork& network, const NetworkCase& in_numbers) {
  const Topology& topology = in_numbers.mechanism.topology;
  for (std::size_t e = 0; e < network.couplings.size(); ++e) {
    const CouplingTopology& bound = topology.couplings[e];
    SCOPED_TRACE(bound.name);
    if (is_complementary(network.couplings[e], network.space())) {
      EXPECT_EQ(bound.freedom_count + passive_count(topology, bound), in_numbers.order());
    }
  }
}

VecX expect_solved_motions(const NetworkCase& network, const std::vector<Primary>& primaries) {
  const KinematicSolution solution =
      solve_velocity(network.mechanism, network.twist_basis, primaries);
  if (solution.status != SolveStatus::solved) {
    ADD_FAILURE() << "the motions are " << word_of(solution.status);
    return VecX::Zero(network.M_N.cols());
  }
  const VecX rates = rates_of(solution);
  const VecX expected = solve_partition(network.M_N, primaries);

  EXPECT_EQ(solution.counts.net_freedom, static_cast<int>(primaries.size()));
  EXPECT_LE(solution.residual, kAgreement);
  expect_annulled(network.M_N, rates);
  EXPECT_TRUE(is_near(rates, expected, kAgreement * size_of(expected)));
  return rates;
}

VecX expect_solved_actions(const NetworkCase& network, const std::vector<Primary>& primaries) {
  const StaticSolution solution = solve_action(network.mechanism, network.wrench_basis, primaries);
  if (solution.status != SolveStatus::solved) {
    ADD_FAILURE() << "the actions are " << word_of(solution.status);
    return VecX::Zero(network.A_N.cols());
  }
  const VecX magnitudes = magnitudes_of(solution);
  const VecX expected = solve_partition(network.A_N, primaries);

  EXPECT_EQ(solution.counts.net_constraint, static_cast<int>(primaries.size()));
  EXPECT_LE(solution.residual, kAgreement);
  expect_annulled(network.A_N, magnitudes);
  EXPECT_TRUE(is_near(magnitudes, expected, kAgreement * size_of(expected)));
  return magnitudes;
}

void expect_motions_in_minimal_order(const NetworkCase& network,
                                     const std::vector<Primary>& primaries) {
  const CoordinateBasis minimal = motion_basis(network.mechanism.geometry, OrderChoice::minimal);

  const KinematicSolution solution = solve_velocity(network.mechanism, minimal, primaries);

  ASSERT_EQ(solution.status, SolveStatus::solved);
  const VecX expected = rates_of(solve_velocity(network.mechanism, network.twist_basis, primaries));
  EXPECT_TRUE(is_near(rates_of(solution), expected, kAgreement * size_of(expected)));
}

void expect_actions_in_minimal_order(const NetworkCase& network,
                                     const std::vector<Primary>& primaries) {
  const CoordinateBasis minimal = action_basis(network.mechanism.geometry, OrderChoice::minimal);

  const StaticSolution solution = solve_action(network.mechanism, minimal, primaries);

  ASSERT_EQ(solution.status, SolveStatus::solved);
  const VecX expected =
      magnitudes_of(solve_action(network.mechanism, network.wrench_basis, primaries));
  EXPECT_TRUE(is_near(magnitudes_of(solution), expected, kAgreement * size_of(expected)));
}

double expect_balanced_power(const NetworkCase& network,
                             const VecX& rates,
                             const VecX& magnitudes) {
  const Mat6X twists = coupling_twists(network.mechanism, rates);
  const Mat6X wrenches = coupling_wrenches(network.mechanism, magnitudes);
  const Mat6X terms = wrenches.cwiseProduct(twists);
  // Of the magnitudes, not of the sums: actions may cancel within a coupling, as those of two
  // actuators on one freedom.
  const double size = size_of(magnitudes) * size_of(rates);

  EXPECT_LE(std::abs(terms.sum()), kAgreement * size);
  return size == 0.0 ? 0.0 : size_of(terms.colwise().sum()) / size;
}

}  // namespace kinestat
