#include <gtest/gtest.h>

#include "property/invariances.hpp"
#include "property/shard.hpp"

namespace kinestat {
namespace {

class Invariance : public RandomNetworks {
 protected:
  /// Runs `check(trial, original)` with one solution of every network.
  template <class Check>
  void for_each_trial(const Check& check) {
    for_each_network(
        [&](const RandomNetwork& network, const NetworkCase& original, std::uint64_t seed) {
          const Answers answers = solve_both(original, seed);
          check(Trial{.network = network, .answers = answers, .seed = seed}, original);
        });
  }
};

INSTANTIATE_TEST_SUITE_P(Seed, Invariance, ::testing::Range(0, kFirstSmallSeed, kToNextShard));

TEST_P(Invariance, OfAllAnswersToAnotherSpanningTree) {
  for_each_trial(
      [](const Trial& trial, const NetworkCase&) { expect_answers_with_another_tree(trial); });
}

TEST_P(Invariance, OfAllAnswersToReversedEdgesButForTheirSigns) {
  for_each_trial(
      [](const Trial& trial, const NetworkCase&) { expect_answers_with_reversed_edges(trial); });
}

TEST_P(Invariance, OfAllAnswersToRenumberedBodies) {
  for_each_trial(
      [](const Trial& trial, const NetworkCase&) { expect_answers_with_renumbered_bodies(trial); });
}

TEST_P(Invariance, OfAllAnswersToARigidMotionOfTheWorldWithWhichTheyMove) {
  for_each_trial([](const Trial& trial, const NetworkCase&) { expect_moved_answers(trial); });
}

TEST_P(Invariance, OfTwistsOfBodiesToARigidMotionOfTheWorldWithWhichTheyMove) {
  for_each_trial([](const Trial& trial, const NetworkCase& original) {
    expect_moved_bodies(trial, original);
  });
}

TEST_P(Invariance, OfTheMinimalOrdersToARigidMotionOfTheWorld) {
  for_each_trial([](const Trial& trial, const NetworkCase& original) {
    expect_orders_when_moved(trial, original);
  });
}

// Not by powers of two, so that everything is rounded anew.
TEST_P(Invariance, OfRotationsAndForcesToLengthsAMillionTimesAsLong) {
  for_each_trial([](const Trial& trial, const NetworkCase&) { expect_scaled_answers(trial, 1e6); });
}

TEST_P(Invariance, OfRotationsAndForcesToLengthsABillionTimesAsShort) {
  for_each_trial(
      [](const Trial& trial, const NetworkCase&) { expect_scaled_answers(trial, 1e-9); });
}

}  // namespace
}  // namespace kinestat
