#include "property/invariances.hpp"

#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "network/bases.hpp"
#include "support/near.hpp"

namespace kinestat {

namespace {

// Primaries of a network of which the solution is to be `values`: the given ones, else any.
std::vector<Primary> primary_motions(const NetworkCase& network,
                                     std::vector<Primary> given,
                                     const VecX& values,
                                     std::uint64_t seed) {
  Random random(seed);
  std::vector<Primary> primaries =
      given.empty() ? choose_motions(network, random) : std::move(given);
  for (Primary& primary : primaries) {
    primary.value = values[primary.index];
  }
  return primaries;
}

std::vector<Primary> primary_actions(const NetworkCase& network,
                                     const VecX& values,
                                     std::uint64_t seed) {
  Random random(seed);
  std::vector<Primary> primaries = choose_actions(network, random);
  for (Primary& primary : primaries) {
    primary.value = values[primary.index];
  }
  return primaries;
}

// The changed network must have the expected answers as its own.
void expect_answers(const NetworkCase& changed, const Answers& expected, std::uint64_t seed) {
  const VecX rates = expect_solved_motions(
      changed,
      primary_motions(
          changed, expected.motions, freedom_rates(changed, expected.twists), seed + 1));
  const Mat6X twists = coupling_twists(changed.mechanism, rates);
  EXPECT_TRUE(is_near(twists, expected.twists, kAgreement * expected.rate_size));

  const VecX values = action_magnitudes(changed, expected.wrenches, expected.internal);
  const VecX magnitudes =
      expect_solved_actions(changed, primary_actions(changed, values, seed + 1));
  const Mat6X wrenches = coupling_wrenches(changed.mechanism, magnitudes);
  const Mat6X internal = internal_wrenches(changed.mechanism, magnitudes);
  EXPECT_TRUE(is_near(wrenches, expected.wrenches, kAgreement * expected.action_size));
  EXPECT_TRUE(is_near(internal, expected.internal, kAgreement * expected.action_size));
}

template <class Screw>
Mat6X moved(Mat6X screws, const RigidMotion& motion) {
  for (auto column : screws.colwise()) {
    column = (motion * Screw::from_coordinates(column)).coordinates();
  }
  return screws;
}

NetworkCase moved_case(const Trial& trial) {
  return make_network_case(
      bind_network(moved(trial.network, make_random_motion(trial.network, trial.seed))));
}

}  // namespace

Answers solve_both(const NetworkCase& network, std::uint64_t seed) {
  Random random(seed);
  Answers answers;
  answers.motions = choose_motions(network, random);
  const VecX rates = expect_solved_motions(network, answers.motions);
  answers.twists = coupling_twists(network.mechanism, rates);
  answers.rate_size = std::max(size_of(rates), size_of(answers.twists));
  const VecX magnitudes = expect_solved_actions(network, choose_actions(network, random));
  answers.wrenches = coupling_wrenches(network.mechanism, magnitudes);
  answers.internal = internal_wrenches(network.mechanism, magnitudes);
  answers.action_size = std::max(size_of(magnitudes), size_of(answers.wrenches));
  answers.length = network.mechanism.geometry.length;
  return answers;
}

void expect_answers_with_another_tree(const Trial& trial) {
  const NetworkCase changed =
      make_network_case(bind_network(with_another_tree(trial.network, trial.seed)));

  expect_orthogonal_graph(changed.mechanism.graph);
  expect_equal_ranks(changed);
  expect_answers(changed, trial.answers, trial.seed);
}

void expect_answers_with_renumbered_bodies(const Trial& trial) {
  const NetworkCase changed =
      make_network_case(bind_network(with_renumbered_bodies(trial.network, trial.seed)));

  expect_answers(changed, trial.answers, trial.seed);
}

void expect_answers_with_reversed_edges(const Trial& trial) {
  std::vector<bool> reversed;
  const NetworkCase changed =
      make_network_case(bind_network(with_reversed_edges(trial.network, trial.seed, reversed)));
  Answers expected = trial.answers;
  expected.motions.clear();  // a universal and a cable number their freedoms anew
  const Topology& topology = changed.mechanism.topology;
  for (std::size_t e = 0; e < reversed.size(); ++e) {
    const double sign = reversed[e] ? -1.0 : 1.0;
    expected.twists.col(static_cast<Eigen::Index>(e)) *= sign;
    expected.wrenches.col(static_cast<Eigen::Index>(e)) *= sign;
  }
  for (std::size_t i = 0; i < topology.actuators.size(); ++i) {
    const auto action = static_cast<std::size_t>(topology.actuators[i].action);
    const auto e = static_cast<std::size_t>(topology.actions[action].coupling.value);
    expected.internal.col(static_cast<Eigen::Index>(i)) *= reversed[e] ? -1.0 : 1.0;
  }

  expect_answers(changed, expected, trial.seed);
}

void expect_moved_answers(const Trial& trial) {
  const RigidMotion motion = make_random_motion(trial.network, trial.seed);
  Answers expected = trial.answers;
  expected.motions.clear();  // freedoms along the axes of the world do not move
  expected.twists = moved<Twist>(expected.twists, motion);
  expected.wrenches = moved<Wrench>(expected.wrenches, motion);
  expected.internal = moved<Wrench>(expected.internal, motion);

  expect_answers(moved_case(trial), expected, trial.seed);
}

void expect_moved_bodies(const Trial& trial, const NetworkCase& original) {
  const RigidMotion motion = make_random_motion(trial.network, trial.seed);
  const auto before =
      solve_velocity(original.mechanism, original.twist_basis, trial.answers.motions);
  const NetworkCase changed = moved_case(trial);
  const VecX rates = freedom_rates(changed, moved<Twist>(trial.answers.twists, motion));

  const auto after = solve_velocity(
      changed.mechanism, changed.twist_basis, primary_motions(changed, {}, rates, trial.seed));

  ASSERT_EQ(after.status, SolveStatus::solved);
  const double size = size_of(rates_of(before)) * (1.0 + original.mechanism.geometry.length);
  const Mat6X expected = moved<Twist>(body_twists(original.mechanism, before), motion);
  EXPECT_TRUE(is_near(body_twists(changed.mechanism, after), expected, kAgreement * size));
}

void expect_orders_when_moved(const Trial& trial, const NetworkCase& original) {
  const Mechanism changed =
      bind_network(moved(trial.network, make_random_motion(trial.network, trial.seed)));
  const Geometry& before = original.mechanism.geometry;

  EXPECT_EQ(motion_basis(changed.geometry, OrderChoice::minimal).order(),
            motion_basis(before, OrderChoice::minimal).order());
  EXPECT_EQ(action_basis(changed.geometry, OrderChoice::minimal).order(),
            action_basis(before, OrderChoice::minimal).order());
}

// The answers are compared in the units of the original. Its length counts, because the program
// gives one of its own to a mechanism whose couplings are all at one point.
void expect_scaled_answers(const Trial& trial, double factor) {
  const NetworkCase changed = make_network_case(bind_network(scaled(trial.network, factor)));
  const Answers& expected = trial.answers;
  const double length = factor * expected.length;
  Vec6 twist_units = Vec6::Ones();
  twist_units.tail<3>() *= factor;
  Vec6 wrench_units = Vec6::Ones();
  wrench_units.head<3>() *= factor;
  const VecX rates = freedom_rates(changed, twist_units.asDiagonal() * expected.twists, length);
  const VecX magnitudes = action_magnitudes(changed,
                                            wrench_units.asDiagonal() * expected.wrenches,
                                            wrench_units.asDiagonal() * expected.internal,
                                            length);

  const auto motion = solve_velocity(changed.mechanism,
                                     changed.twist_basis,
                                     primary_motions(changed, expected.motions, rates, trial.seed));
  const auto action = solve_action(changed.mechanism,
                                   changed.wrench_basis,
                                   primary_actions(changed, magnitudes, trial.seed + 1));

  ASSERT_EQ(motion.status, SolveStatus::solved);
  ASSERT_EQ(action.status, SolveStatus::solved);
  const Mat6X twists =
      twist_units.asDiagonal().inverse() * coupling_twists(changed.mechanism, rates_of(motion));
  const Mat6X wrenches = wrench_units.asDiagonal().inverse() *
                         coupling_wrenches(changed.mechanism, magnitudes_of(action));
  EXPECT_TRUE(is_near(twists, expected.twists, kAgreement * expected.rate_size));
  EXPECT_TRUE(is_near(wrenches, expected.wrenches, kAgreement * expected.action_size));
}

}  // namespace kinestat
