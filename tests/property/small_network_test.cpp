#include <gtest/gtest.h>

#include "property/invariances.hpp"
#include "property/shard.hpp"

namespace kinestat {
namespace {

// Many networks, so all identities of one are tested on what is bound and solved once.
class SmallNetworks : public RandomNetworks {};

INSTANTIATE_TEST_SUITE_P(Seed,
                         SmallNetworks,
                         ::testing::Range(kFirstSmallSeed, kSeedCount, kToNextSmallShard));

// Of the graph, of every coupling, and of the ranks.
TEST_P(SmallNetworks, SatisfyTheIdentitiesOfCounts) {
  for_each_network(
      [](const RandomNetwork& network, const NetworkCase& in_numbers, std::uint64_t seed) {
        expect_orthogonal_graph(in_numbers.mechanism.graph);
        expect_reciprocal_couplings(in_numbers);
        expect_equal_ranks(in_numbers);
        expect_complementary_couplings(network, in_numbers);
        const bool is_complementary =
            couplings_are_complementary(in_numbers.mechanism, in_numbers.order());
        EXPECT_TRUE(is_complementary || seed % 2 == 1);
        if (is_complementary) {
          expect_complementary_counts(in_numbers);
        }
      });
}

TEST_P(SmallNetworks, SatisfyTheLawsAndNeitherGainNorLosePower) {
  int flowing = 0;
  for_each_network([&](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    Random random(seed);
    const std::vector<Primary> motions = choose_motions(network, random);
    const std::vector<Primary> actions = choose_actions(network, random);
    const VecX rates = expect_solved_motions(network, motions);
    const VecX magnitudes = expect_solved_actions(network, actions);
    flowing += expect_balanced_power(network, rates, magnitudes) > 1e-3 ? 1 : 0;
    expect_motions_in_minimal_order(network, motions);
    expect_actions_in_minimal_order(network, actions);
  });
  RecordProperty("flowing", flowing);
  EXPECT_GE(flowing, size() / 20);
}

TEST_P(SmallNetworks, KeepTheirAnswersWhereTheyMust) {
  for_each_network(
      [](const RandomNetwork& network, const NetworkCase& original, std::uint64_t seed) {
        const Answers answers = solve_both(original, seed);
        const Trial trial{.network = network, .answers = answers, .seed = seed};
        {
          SCOPED_TRACE("another tree");
          expect_answers_with_another_tree(trial);
        }
        {
          SCOPED_TRACE("reversed edges");
          expect_answers_with_reversed_edges(trial);
        }
        {
          SCOPED_TRACE("renumbered bodies");
          expect_answers_with_renumbered_bodies(trial);
        }
        {
          SCOPED_TRACE("moved world");
          expect_moved_answers(trial);
          expect_moved_bodies(trial, original);
          expect_orders_when_moved(trial, original);
        }
        {
          SCOPED_TRACE("longer lengths");
          expect_scaled_answers(trial, 1e6);
        }
        {
          SCOPED_TRACE("shorter lengths");
          expect_scaled_answers(trial, 1e-9);
        }
      });
}

}  // namespace
}  // namespace kinestat
