// Properties of the values that complete equilibrium, over the random networks.
#include "statics/indeterminacy.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>
#include <gtest/gtest.h>

#include "network/node_system.hpp"
#include "property/held_loads.hpp"
#include "property/identities.hpp"
#include "property/network_answers.hpp"
#include "property/shard.hpp"
#include "support/near.hpp"

namespace kinestat {
namespace {

class Indeterminacy : public RandomNetworks {};

INSTANTIATE_TEST_SUITE_P(Seed, Indeterminacy, ::testing::Range(0, kFirstSmallSeed, kToNextShard));
INSTANTIATE_TEST_SUITE_P(SmallSpatialSeed,
                         Indeterminacy,
                         ::testing::Range(kFirstSmallSeed, kSeedCount, kToNextSmallShard));

// Half of the primaries that the network needs, and loads that it can hold.
struct Problem {
  std::vector<Primary> primaries;
  std::vector<BodyWrench> loads;
};

Problem make_problem(const NetworkCase& network, std::uint64_t seed) {
  Random random(seed);
  Problem problem{.primaries = choose_actions(network, random), .loads = {}};
  problem.primaries.resize(problem.primaries.size() / 2);
  problem.loads = make_held_loads(network.mechanism, random).loads;
  return problem;
}

StaticSolution solve(const NetworkCase& network,
                     const Mechanism& mechanism,
                     const Problem& problem) {
  return resolve_indeterminacy(
      mechanism,
      network.wrench_basis,
      problem.primaries,
      problem.loads,
      solve_action(mechanism, network.wrench_basis, problem.primaries, problem.loads));
}

// The second way: the shortest y with A diag(1/w) y = -loads - A_P ψ_P, from the pseudo-inverse by
// a complete orthogonal decomposition; ψ = y/w. Weights of the primaries do not count.
VecX shortest(const NetworkCase& network, const Problem& problem, const VecX& weights) {
  const Topology& topology = network.mechanism.topology;
  MatX A = action_system(topology, network.mechanism.geometry, network.wrench_basis).dense();
  for (int a = 0; a < topology.action_count(); ++a) {
    A.col(a) /= action_unit(topology, network.wrench_basis, a);
  }
  const std::vector<double> loads =
      load_vector(topology.body_count(), network.wrench_basis, problem.loads);
  VecX right = Eigen::Map<const VecX>(loads.data(), A.rows());
  MatX weighted = A * weights.cwiseInverse().asDiagonal();
  VecX result = VecX::Zero(A.cols());
  for (const Primary& primary : problem.primaries) {
    right -= primary.value * A.col(primary.index);
    weighted.col(primary.index).setZero();
    result[primary.index] = primary.value;
  }
  Eigen::CompleteOrthogonalDecomposition<MatX> pseudo;
  pseudo.setThreshold(1e-9);
  pseudo.compute(weighted);
  const VecX y = pseudo.solve(right);
  for (int a = 0; a < result.size(); ++a) {
    const auto primary = std::ranges::find(problem.primaries, a, &Primary::index);
    result[a] = primary == problem.primaries.end() ? y[a] / weights[a] : result[a];
  }
  return result;
}

TEST_P(Indeterminacy, HasTheLeastNormOfThePseudoInverse) {
  int open = 0;
  for_each_network([&](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    Mechanism mechanism = network.mechanism;
    mechanism.indeterminate = IndeterminateChoice::minimum_norm;
    const Problem problem = make_problem(network, seed);

    const StaticSolution solution = solve(network, mechanism, problem);

    VecX weights(mechanism.topology.action_count());
    for (int a = 0; a < weights.size(); ++a) {
      const bool is_couple = mechanism.topology.actions[static_cast<std::size_t>(a)].is_couple;
      weights[a] = is_couple ? 1.0 / mechanism.geometry.length : 1.0;
    }
    const VecX expected = shortest(network, problem, weights);
    EXPECT_TRUE(is_near(magnitudes_of(solution), expected, kAgreement * size_of(expected)));
    open += solution.completion.actions.empty() ? 0 : 1;
    EXPECT_EQ(solution.completion.actions, solution.check.undetermined);
  });
  EXPECT_GE(open, 1) << "no network of the shard is indeterminate";
}

TEST_P(Indeterminacy, HasTheLeastEnergyOfElasticCouplings) {
  for_each_network([](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    Mechanism mechanism = network.mechanism;
    mechanism.indeterminate = IndeterminateChoice::stiffness;
    Random random(seed + 1);
    VecX weights(mechanism.topology.action_count());
    for (int a = 0; a < weights.size(); ++a) {
      const bool is_couple = mechanism.topology.actions[static_cast<std::size_t>(a)].is_couple;
      const double length = is_couple ? mechanism.geometry.length : 1.0;
      const double compliance = random.between(0.5, 2.0) / (length * length);
      mechanism.compliances[static_cast<std::size_t>(a)] = compliance;
      weights[a] = std::sqrt(compliance);
    }
    const Problem problem = make_problem(network, seed);

    const StaticSolution solution = solve(network, mechanism, problem);

    const VecX expected = shortest(network, problem, weights);
    ASSERT_EQ(solution.status, SolveStatus::solved);
    EXPECT_TRUE(is_near(magnitudes_of(solution), expected, kAgreement * size_of(expected)));
    EXPECT_LE(solution.residual, kAgreement);
  });
}

TEST_P(Indeterminacy, HasSelfStressesThatNeedNoLoad) {
  for_each_network([](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    const Problem problem = make_problem(network, seed);
    const StaticSolution solution = solve(network, network.mechanism, problem);

    for (const SelfStress& stress : solution.self_stresses) {
      VecX magnitudes = VecX::Zero(network.A_N.cols());
      for (const DependenceTerm& term : stress.terms) {
        magnitudes[term.index] = term.coefficient;
      }
      const VecX sums = network.A_N * magnitudes;
      EXPECT_LE(size_of(sums), kAgreement * size_of(network.A_N) * size_of(magnitudes));
      EXPECT_EQ(magnitudes[stress.terms.front().index], 1.0);
      for (const Primary& primary : problem.primaries) {
        EXPECT_EQ(magnitudes[primary.index], 0.0);
      }
    }
    EXPECT_TRUE(solution.self_stresses.empty() ||
                static_cast<int>(solution.self_stresses.size()) == solution.check.missing);
  });
}

}  // namespace
}  // namespace kinestat
