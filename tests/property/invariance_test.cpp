#include <algorithm>

#include <gtest/gtest.h>

#include "network/bases.hpp"
#include "property/identities.hpp"
#include "property/shard.hpp"
#include "support/near.hpp"

namespace kinestat {
namespace {

class Invariance : public RandomNetworks {};

INSTANTIATE_TEST_SUITE_P(Shard, Invariance, ::testing::Range(0, kSeedCount / kShardSize));

// One solution of each side of a network.
struct Answers {
  std::vector<Primary> motions;  ///< the primary ones
  VecX rates;
  Mat6X wrenches;                ///< of each coupling
  std::vector<double> internal;  ///< magnitude of each actuator's action
  double action_size = 0.0;      ///< the largest magnitude: wrenches may cancel within couplings
};

Answers solve(const NetworkCase& network, std::uint64_t seed) {
  Random random(seed);
  Answers answers;
  answers.motions = choose_motions(network, random);
  answers.rates = expect_solved_motions(network, answers.motions);
  const VecX magnitudes = expect_solved_actions(network, choose_actions(network, random));
  answers.wrenches = coupling_wrenches(network.mechanism, magnitudes);
  answers.action_size = std::max(size_of(magnitudes), size_of(answers.wrenches));
  for (const ActuatorTopology& actuator : network.mechanism.topology.actuators) {
    answers.internal.push_back(magnitudes[actuator.action]);
  }
  return answers;
}

// The changed network must have the expected answers as its own: its primaries are the same
// freedoms, and any actions that are valid there, with the expected values.
void expect_answers(const NetworkCase& changed, const Answers& expected, std::uint64_t seed) {
  std::vector<Primary> motions = expected.motions;
  for (Primary& primary : motions) {
    primary.value = expected.rates[primary.index];
  }
  const VecX rates = expect_solved_motions(changed, motions);
  EXPECT_TRUE(is_near(rates, expected.rates, kAgreement * size_of(expected.rates)));

  Random random(seed + 1);
  const VecX magnitudes =
      action_magnitudes(changed.mechanism, expected.wrenches, expected.internal);
  std::vector<Primary> actions = choose_actions(changed, random);
  for (Primary& primary : actions) {
    primary.value = magnitudes[primary.index];
  }
  const Mat6X wrenches =
      coupling_wrenches(changed.mechanism, expect_solved_actions(changed, actions));
  EXPECT_TRUE(is_near(wrenches, expected.wrenches, kAgreement * expected.action_size));
}

TEST_P(Invariance, OfAllAnswersToAnotherSpanningTree) {
  for_each_network(
      [](const RandomNetwork& network, const NetworkCase& original, std::uint64_t seed) {
        const NetworkCase changed =
            make_network_case(bind_network(with_another_tree(network, seed)));

        expect_orthogonal_graph(changed.mechanism.graph);
        expect_equal_ranks(changed);
        expect_answers(changed, solve(original, seed), seed);
      });
}

TEST_P(Invariance, OfAllAnswersToReversedEdgesButForTheirSigns) {
  for_each_network(
      [](const RandomNetwork& network, const NetworkCase& original, std::uint64_t seed) {
        std::vector<bool> reversed;
        const NetworkCase changed =
            make_network_case(bind_network(with_reversed_edges(network, seed, reversed)));
        Answers expected = solve(original, seed);
        const Topology& topology = original.mechanism.topology;
        for (int f = 0; f < topology.freedom_count(); ++f) {
          const int e = topology.freedoms[static_cast<std::size_t>(f)].coupling.value;
          expected.rates[f] *= reversed[static_cast<std::size_t>(e)] ? -1.0 : 1.0;
        }
        for (int e = 0; e < topology.coupling_count(); ++e) {
          expected.wrenches.col(e) *= reversed[static_cast<std::size_t>(e)] ? -1.0 : 1.0;
        }
        for (std::size_t i = 0; i < expected.internal.size(); ++i) {
          const int action = topology.actuators[i].action;
          const int e = topology.actions[static_cast<std::size_t>(action)].coupling.value;
          expected.internal[i] *= reversed[static_cast<std::size_t>(e)] ? -1.0 : 1.0;
        }

        expect_answers(changed, expected, seed);
      });
}

TEST_P(Invariance, OfAllAnswersToRenumberedBodies) {
  for_each_network(
      [](const RandomNetwork& network, const NetworkCase& original, std::uint64_t seed) {
        const NetworkCase changed =
            make_network_case(bind_network(with_renumbered_bodies(network, seed)));

        expect_answers(changed, solve(original, seed), seed);
      });
}

TEST_P(Invariance, OfRatesToARigidMotionOfTheWorldWithWhichTheWrenchesMove) {
  for_each_network([](const RandomNetwork& network,
                      const NetworkCase& original,
                      std::uint64_t seed) {
    const RigidMotion motion = make_random_motion(network.space, seed);
    const NetworkCase changed = make_network_case(bind_network(moved(network, motion)));
    Answers expected = solve(original, seed);
    for (int e = 0; e < expected.wrenches.cols(); ++e) {
      const Vec6 wrench = expected.wrenches.col(e);
      expected.wrenches.col(e) =
          (motion * Wrench{.moment = wrench.head<3>(), .force = wrench.tail<3>()}).coordinates();
    }

    expect_answers(changed, expected, seed);
  });
}

TEST_P(Invariance, OfTwistsToARigidMotionOfTheWorldWithWhichTheyMove) {
  for_each_network(
      [](const RandomNetwork& network, const NetworkCase& original, std::uint64_t seed) {
        Random random(seed);
        const std::vector<Primary> primaries = choose_motions(original, random);
        const RigidMotion motion = make_random_motion(network.space, seed);
        const Mechanism changed = bind_network(moved(network, motion));
        const auto before = solve_velocity(original.mechanism, original.twist_basis, primaries);

        const auto after = solve_velocity(changed, original.twist_basis, primaries);

        ASSERT_EQ(after.status, SolveStatus::solved);
        for (std::size_t b = 0; b < before.bodies.size(); ++b) {
          const Vec6 expected = (motion * before.bodies[b]).coordinates();
          const double size =
              size_of(rates_of(before)) * (1.0 + original.mechanism.geometry.length);
          EXPECT_TRUE(is_near(after.bodies[b].coordinates(), expected, kAgreement * size));
        }
      });
}

TEST_P(Invariance, OfTheMinimalOrdersToARigidMotionOfTheWorld) {
  for_each_network(
      [](const RandomNetwork& network, const NetworkCase& original, std::uint64_t seed) {
        const Mechanism changed =
            bind_network(moved(network, make_random_motion(network.space, seed)));
        const Geometry& before = original.mechanism.geometry;
        const Geometry& after = changed.geometry;

        EXPECT_EQ(motion_basis(after, OrderChoice::minimal).order(),
                  motion_basis(before, OrderChoice::minimal).order());
        EXPECT_EQ(action_basis(after, OrderChoice::minimal).order(),
                  action_basis(before, OrderChoice::minimal).order());
      });
}

// Rotations and forces stay, translations and moments grow with the lengths. Not a power of two, so
// that everything is rounded anew.
void expect_scaled_answers(const RandomNetwork& network,
                           const NetworkCase& original,
                           double factor,
                           std::uint64_t seed) {
  const NetworkCase changed = make_network_case(bind_network(scaled(network, factor)));
  const Answers answers = solve(original, seed);
  const Topology& topology = original.mechanism.topology;
  std::vector<Primary> motions = answers.motions;
  for (Primary& primary : motions) {
    const bool is_rotation = topology.freedoms[static_cast<std::size_t>(primary.index)].is_rotation;
    primary.value *= is_rotation ? 1.0 : factor;
  }
  Mat6X wrenches = answers.wrenches;
  wrenches.topRows<3>() *= factor;
  std::vector<double> internal = answers.internal;
  for (std::size_t i = 0; i < internal.size(); ++i) {
    const int action = topology.actuators[i].action;
    internal[i] *= topology.actions[static_cast<std::size_t>(action)].is_couple ? factor : 1.0;
  }
  const VecX magnitudes = action_magnitudes(changed.mechanism, wrenches, internal);
  Random random(seed + 1);
  std::vector<Primary> actions = choose_actions(changed, random);
  for (Primary& primary : actions) {
    primary.value = magnitudes[primary.index];
  }

  const auto motion = solve_velocity(changed.mechanism, changed.twist_basis, motions);
  const auto action = solve_action(changed.mechanism, changed.wrench_basis, actions);

  ASSERT_EQ(motion.status, SolveStatus::solved);
  ASSERT_EQ(action.status, SolveStatus::solved);
  VecX rates = rates_of(motion);
  for (int f = 0; f < topology.freedom_count(); ++f) {
    rates[f] /= topology.freedoms[static_cast<std::size_t>(f)].is_rotation ? 1.0 : factor;
  }
  EXPECT_TRUE(is_near(rates, answers.rates, kAgreement * size_of(answers.rates)));
  Mat6X back = coupling_wrenches(changed.mechanism, magnitudes_of(action));
  back.topRows<3>() /= factor;
  EXPECT_TRUE(is_near(back, answers.wrenches, kAgreement * answers.action_size));
}

TEST_P(Invariance, OfRotationsAndForcesToLengthsAMillionTimesAsLong) {
  for_each_network([](const RandomNetwork& network,
                      const NetworkCase& original,
                      std::uint64_t seed) { expect_scaled_answers(network, original, 1e6, seed); });
}

TEST_P(Invariance, OfRotationsAndForcesToLengthsABillionTimesAsShort) {
  for_each_network(
      [](const RandomNetwork& network, const NetworkCase& original, std::uint64_t seed) {
        expect_scaled_answers(network, original, 1e-9, seed);
      });
}

}  // namespace
}  // namespace kinestat
