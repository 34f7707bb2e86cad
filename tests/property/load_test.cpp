// Properties of actions under loads, over the random networks.
#include <algorithm>

#include <gtest/gtest.h>

#include "network/node_system.hpp"
#include "power/power_flow.hpp"
#include "property/held_loads.hpp"
#include "property/identities.hpp"
#include "property/network_answers.hpp"
#include "property/shard.hpp"
#include "support/near.hpp"
#include "support/random_network_changes.hpp"

namespace kinestat {
namespace {

class Loads : public RandomNetworks {};

INSTANTIATE_TEST_SUITE_P(Seed, Loads, ::testing::Range(0, kFirstSmallSeed, kToNextShard));
INSTANTIATE_TEST_SUITE_P(SmallSpatialSeed,
                         Loads,
                         ::testing::Range(kFirstSmallSeed, kSeedCount, kToNextSmallShard));

TEST_P(Loads, AreHeldByActionsThatSatisfyTheCutsetLaw) {
  for_each_network([](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    Random random(seed);
    const std::vector<Primary> primaries = choose_actions(network, random);
    const HeldLoads held = make_held_loads(network.mechanism, random);

    const StaticSolution solution =
        solve_action(network.mechanism, network.wrench_basis, primaries, held.loads);

    ASSERT_EQ(solution.status, SolveStatus::solved);
    EXPECT_LE(solution.residual, kAgreement);
    // The difference of two ways to hold the loads holds nothing: A_N (ψ - ψ_0) = 0. By the
    // textbook, it follows from its primary magnitudes.
    const VecX difference = magnitudes_of(solution) - held.held_by;
    std::vector<Primary> known = primaries;
    for (Primary& primary : known) {
      primary.value -= held.held_by[primary.index];
    }
    const VecX expected = solve_partition(network.A_N, known);
    const double size = size_of(held.held_by) + size_of(expected);
    EXPECT_TRUE(is_near(difference, expected, kAgreement * size));
  });
}

TEST_P(Loads, InsteadOfAnActionLeaveTheOtherActionsAsTheyWere) {
  for_each_network([](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    const Mechanism& mechanism = network.mechanism;
    Random random(seed);
    std::vector<Primary> primaries = choose_actions(network, random);
    VecX expected = magnitudes_of(solve_action(mechanism, network.wrench_basis, primaries));
    const double size = size_of(expected);
    const int replaced = random.whole(0, mechanism.topology.action_count() - 1);
    const ActionLabel& label = mechanism.topology.actions[static_cast<std::size_t>(replaced)];
    const CouplingTopology& coupling = mechanism.topology.coupling(label.coupling);
    const Wrench wrench =
        expected[replaced] * mechanism.geometry.actions[static_cast<std::size_t>(replaced)];
    const std::vector<BodyWrench> loads = {{.body = coupling.head, .wrench = wrench},
                                           {.body = coupling.tail, .wrench = -1.0 * wrench}};
    const auto primary = std::ranges::find(primaries, replaced, &Primary::index);
    if (primary != primaries.end()) {
      primary->value = 0.0;
    }

    const StaticSolution solution = solve_action(mechanism, network.wrench_basis, primaries, loads);

    ASSERT_EQ(solution.status, SolveStatus::solved);
    expected[replaced] = 0.0;
    EXPECT_TRUE(is_near(magnitudes_of(solution), expected, kAgreement * size));
  });
}

TEST_P(Loads, TakePartInTheBalanceOfPower) {
  int flowing = 0;
  for_each_network([&](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    const Mechanism& mechanism = network.mechanism;
    Random random(seed);
    Case which;
    which.motions = choose_motions(network, random);
    which.actions = choose_actions(network, random);
    for (const BodyWrench& load : make_held_loads(mechanism, random).loads) {
      which.loads.push_back({.name = "load", .acts = load, .point = std::nullopt, .where = {}});
    }
    const auto motion = solve_velocity(mechanism, network.twist_basis, which.motions);
    const auto action =
        solve_action(mechanism, network.wrench_basis, which.actions, wrenches_of(which.loads));
    ASSERT_EQ(motion.status, SolveStatus::solved);
    ASSERT_EQ(action.status, SolveStatus::solved);

    const PowerFlow flow = find_power(mechanism, which, motion, action);

    const double size = size_of(magnitudes_of(action)) * size_of(rates_of(motion));
    double sum = 0.0;
    double largest = 0.0;
    for (const auto* powers : {&flow.supplied, &flow.loads}) {
      for (const double power : *powers) {
        sum += power;
        largest = std::max(largest, std::abs(power));
      }
    }
    EXPECT_LE(std::abs(sum), kAgreement * size);
    flowing += largest > 1e-3 * size ? 1 : 0;
  });
  EXPECT_GE(flowing, 1) << "no power flows in any network of the shard";
}

// The same loads on a mechanism that has moved.
std::vector<BodyWrench> moved_loads(std::vector<BodyWrench> loads,
                                    const RigidMotion& motion,
                                    const Geometry& before,
                                    const Geometry& after) {
  for (BodyWrench& load : loads) {
    const Wrench in_world = motion * about_world(load.wrench, before.origin);
    load.wrench = {.moment = moment_at(in_world, after.origin.place()), .force = in_world.force};
  }
  return loads;
}

TEST_P(Loads, MoveWithTheWorldAndTheWrenchesWithThem) {
  for_each_network([](const RandomNetwork& network,
                      const NetworkCase& original,
                      std::uint64_t seed) {
    Random random(seed);
    const HeldLoads held = make_held_loads(original.mechanism, random);
    const VecX before = magnitudes_of(solve_action(
        original.mechanism, original.wrench_basis, choose_actions(original, random), held.loads));
    const RigidMotion motion = make_random_motion(network, seed);
    const NetworkCase changed = make_network_case(bind_network(moved(network, motion)));
    Mat6X expected = coupling_wrenches(original.mechanism, before);
    Mat6X internal = internal_wrenches(original.mechanism, before);
    for (Mat6X* wrenches : {&expected, &internal}) {
      for (int e = 0; e < wrenches->cols(); ++e) {
        const Vec6 wrench = wrenches->col(e);
        wrenches->col(e) = (motion * Wrench::from_coordinates(wrench)).coordinates();
      }
    }
    std::vector<Primary> actions = choose_actions(changed, random);
    const VecX magnitudes = action_magnitudes(changed, expected, internal);
    for (Primary& primary : actions) {
      primary.value = magnitudes[primary.index];
    }

    const StaticSolution after = solve_action(
        changed.mechanism,
        changed.wrench_basis,
        actions,
        moved_loads(held.loads, motion, original.mechanism.geometry, changed.mechanism.geometry));

    ASSERT_EQ(after.status, SolveStatus::solved);
    const Mat6X wrenches = coupling_wrenches(changed.mechanism, magnitudes_of(after));
    const double size = std::max({size_of(before), size_of(held.held_by), size_of(expected)});
    EXPECT_TRUE(is_near(wrenches, expected, kAgreement * size));
  });
}

TEST_P(Loads, AreRefusedExactlyWhereTheyAddToTheRank) {
  int refused = 0;
  for_each_network([&](const RandomNetwork&, const NetworkCase& network, std::uint64_t seed) {
    const Mechanism& mechanism = network.mechanism;
    Random random(seed);
    const std::vector<Primary> primaries = choose_actions(network, random);
    Wrench wrench = Wrench::from_coordinates(Vec6::NullaryExpr([&] { return random.magnitude(); }));
    if (network.order() == 3) {
      wrench.moment.head<2>().setZero();
      wrench.force.z() = 0.0;
    }
    const int body = random.whole(1, mechanism.topology.body_count() - 1);
    const std::vector<BodyWrench> loads = {{.body = BodyId{body}, .wrench = wrench}};

    const StaticSolution solution = solve_action(mechanism, network.wrench_basis, primaries, loads);

    // What holds is in the range of the equilibrium, so that the load adds nothing to its rank.
    MatX A = action_system(mechanism.topology, mechanism.geometry, network.wrench_basis).dense();
    const int rank = find_rank(A).rank;
    const std::vector<double> right =
        load_vector(mechanism.topology.body_count(), network.wrench_basis, loads);
    A.conservativeResize(Eigen::NoChange, A.cols() + 1);
    A.rightCols<1>() = Eigen::Map<const VecX>(right.data(), A.rows());
    const bool is_held = find_rank(A).rank == rank;
    EXPECT_EQ(solution.status, is_held ? SolveStatus::solved : SolveStatus::inconsistent);
    if (!is_held) {
      ++refused;
      ASSERT_TRUE(solution.unconstrained.has_value());
      EXPECT_EQ(solution.unconstrained->loads, std::vector<int>{0});
    }
  });
  EXPECT_GE(refused, 1) << "every load of the shard is held";
}

}  // namespace
}  // namespace kinestat
