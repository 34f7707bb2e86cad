#include <gtest/gtest.h>

#include "property/identities.hpp"
#include "property/shard.hpp"

namespace kinestat {
namespace {

INSTANTIATE_TEST_SUITE_P(Seed, RandomNetworks, ::testing::Range(0, kFirstSmallSeed, kToNextShard));

TEST_P(RandomNetworks, HaveCircuitsOrthogonalToCutsets) {
  for_each_network([](const RandomNetwork&, const NetworkCase& network, std::uint64_t) {
    expect_orthogonal_graph(network.mechanism.graph);
    EXPECT_GE(network.mechanism.graph.circuit_count(), 1);
  });
}

TEST_P(RandomNetworks, HaveCouplingsThatDoNoWork) {
  for_each_network([](const RandomNetwork&, const NetworkCase& network, std::uint64_t) {
    expect_reciprocal_couplings(network);
  });
}

TEST_P(RandomNetworks, HaveTheSameRanksAsNodeSystemAndAsTextbookMatrices) {
  for_each_network([](const RandomNetwork&, const NetworkCase& network, std::uint64_t) {
    expect_equal_ranks(network);
  });
}

// The networks of even seeds have no couplings but complementary ones.
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
  EXPECT_GE(complementary, size() / 2 - most_skips());
}

// What is excused is excused by name.
TEST_P(RandomNetworks, HaveFreedomsAndConstraintsForTheOrderOfTheSpaceUnlessExcused) {
  for_each_network([](const RandomNetwork& network, const NetworkCase& in_numbers, std::uint64_t) {
    expect_complementary_couplings(network, in_numbers);
  });
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
    expect_motions_in_minimal_order(network, choose_motions(network, random));
  });
}

TEST_P(RandomNetworks, BearAlikeInTheMinimalOrder) {
  for_each_network([](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    Random random(seed);
    expect_actions_in_minimal_order(network, choose_actions(network, random));
  });
}

}  // namespace
}  // namespace kinestat
