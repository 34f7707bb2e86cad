#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "network/bases.hpp"
#include "property/identities.hpp"
#include "property/shard.hpp"
#include "support/near.hpp"

namespace kinestat {
namespace {

INSTANTIATE_TEST_SUITE_P(Shard, RandomNetworks, ::testing::Range(0, kSeedCount / kShardSize));

TEST_P(RandomNetworks, HaveCircuitsOrthogonalToCutsets) {
  for_each_network([](const RandomNetwork&, const NetworkCase& network, std::uint64_t) {
    expect_orthogonal_graph(network.mechanism.graph);
    EXPECT_GE(network.mechanism.graph.circuit_count(), 1);
  });
}

TEST_P(RandomNetworks, HaveTheSameRanksAsNodeSystemAndAsTextbookMatrices) {
  for_each_network([](const RandomNetwork&, const NetworkCase& network, std::uint64_t) {
    expect_equal_ranks(network);
  });
}

// Gears, clutches and brakes have no f + c = λ; the networks of even seeds are without.
TEST_P(RandomNetworks, OfComplementaryCouplingsHaveTheSameCountsFromBothSides) {
  int complementary = 0;
  for_each_network([&](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    const bool is_complementary = couplings_are_complementary(network.mechanism, network.order());
    EXPECT_TRUE(is_complementary || seed % 2 == 1);
    if (is_complementary) {
      ++complementary;
      expect_complementary_counts(network);
    }
  });
  EXPECT_GE(complementary, kShardSize / 2 - kMostSkips);
}

TEST_P(RandomNetworks, HaveMotionsThatSatisfyTheCircuitLaw) {
  for_each_network([](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    Random random(seed);
    expect_solved_motions(network, choose_motions(network, random));
  });
}

TEST_P(RandomNetworks, HaveActionsThatSatisfyTheCutsetLaw) {
  for_each_network([](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    Random random(seed);
    expect_solved_actions(network, choose_actions(network, random));
  });
}

TEST_P(RandomNetworks, NeitherGainNorLosePower) {
  int flowing = 0;
  for_each_network([&](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    Random random(seed);
    const VecX rates = expect_solved_motions(network, choose_motions(network, random));
    const VecX magnitudes = expect_solved_actions(network, choose_actions(network, random));
    flowing += expect_balanced_power(network, rates, magnitudes) > 1e-3 ? 1 : 0;
  });
  EXPECT_GE(flowing, 1) << "no power flows in any network of the shard";
}

TEST_P(RandomNetworks, MoveAlikeInTheMinimalOrder) {
  for_each_network([](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    Random random(seed);
    const std::vector<Primary> primaries = choose_motions(network, random);
    const CoordinateBasis minimal = motion_basis(network.mechanism.geometry, OrderChoice::minimal);

    const KinematicSolution solution = solve_velocity(network.mechanism, minimal, primaries);

    ASSERT_EQ(solution.status, SolveStatus::solved);
    const VecX expected =
        rates_of(solve_velocity(network.mechanism, network.twist_basis, primaries));
    EXPECT_TRUE(is_near(rates_of(solution), expected, kAgreement * size_of(expected)));
  });
}

TEST_P(RandomNetworks, BearAlikeInTheMinimalOrder) {
  for_each_network([](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    Random random(seed);
    const std::vector<Primary> primaries = choose_actions(network, random);
    const CoordinateBasis minimal = action_basis(network.mechanism.geometry, OrderChoice::minimal);

    const StaticSolution solution = solve_action(network.mechanism, minimal, primaries);

    ASSERT_EQ(solution.status, SolveStatus::solved);
    const VecX expected =
        magnitudes_of(solve_action(network.mechanism, network.wrench_basis, primaries));
    EXPECT_TRUE(is_near(magnitudes_of(solution), expected, kAgreement * size_of(expected)));
  });
}

// What the properties rest on: that the generator makes every kind of network.
TEST(RandomNetwork, IsOfEveryKindAmongTheSeeds) {
  std::set<CouplingType> types;
  std::set<Layout> layouts;
  std::set<int> sizes;
  int redundant = 0;
  int mobile = 0;
  int statically_determined = 0;
  for (std::uint64_t seed = 0; seed < kSeedCount; ++seed) {
    const RandomNetwork network = make_random_network(seed);
    layouts.insert(network.layout);
    sizes.insert(network.body_count());
    for (const NetworkCoupling& coupling : network.couplings) {
      types.insert(coupling.type);
    }
    if (network.body_count() <= 12) {
      const NetworkCase in_numbers = make_network_case(bind_network(network));
      const int rank = find_rank(in_numbers.M_N).rank;
      redundant += rank < in_numbers.M_N.rows() ? 1 : 0;
      statically_determined += rank == in_numbers.M_N.rows() ? 1 : 0;
      mobile += rank < in_numbers.M_N.cols() ? 1 : 0;
    }
  }

  EXPECT_EQ(types.size(), 6U);
  EXPECT_EQ(layouts.size(), 6U);
  EXPECT_EQ(*sizes.begin(), 3);
  EXPECT_EQ(*sizes.rbegin(), 30);
  EXPECT_GE(redundant, 100);
  EXPECT_GE(statically_determined, 30);
  EXPECT_GE(mobile, 100);
}

}  // namespace
}  // namespace kinestat
