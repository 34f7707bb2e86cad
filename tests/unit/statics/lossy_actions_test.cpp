#include "statics/lossy_actions.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "kinematics/velocity.hpp"
#include "network/bases.hpp"
#include "support/mechanism_text.hpp"

namespace kinestat {
namespace {

// The first case of a mechanism with lossy meshes. Accepted are senses that give the last action a
// power below zero, if asked for.
struct Lossy {
  Mechanism mechanism;
  KinematicSolution motion;
  MeshLossLaws losses;
  LossyActions found;

  explicit Lossy(const std::string& text, bool must_pass_on = false)
      : mechanism(mechanism_of(text)) {
    const Case& which = mechanism.cases.front();
    motion = solve_velocity(
        mechanism, motion_basis(mechanism.geometry, OrderChoice::minimal), which.motions);
    EXPECT_EQ(motion.status, SolveStatus::solved);
    losses = find_mesh_loss_laws(mechanism, motion);
    const ActuatorTopology& output = mechanism.topology.actuators.back();
    found = solve_with_losses(
        mechanism,
        action_basis(mechanism.geometry, OrderChoice::planar),
        {.primaries = which.actions, .loads = {}, .frictions = {}, .meshes = losses.laws},
        [&](const VecX& actions) {
          const double speed = motion.rates[static_cast<std::size_t>(output.freedom)];
          return !must_pass_on || actions[output.action] * speed < 0.0;
        });
  }

  double action(const std::string& name) const {
    const auto a = static_cast<std::size_t>(action_index(mechanism, name));
    return found.solution.magnitudes.empty() ? NAN : found.solution.magnitudes[a].value_or(NAN);
  }
};

// A wheel of radius 2 m drives a pinion of 1 m, or is driven by it; the teeth lose 2 %.
std::string pair_of_gears(double torque) {
  return fmt::format(
      "space: planar\n"
      "ground: frame\n"
      "bodies: [wheel, pinion]\n"
      "couplings:\n"
      "  a: {{type: revolute, bodies: [frame, wheel], at: [0, 0]}}\n"
      "  b: {{type: revolute, bodies: [frame, pinion], at: [0, 3]}}\n"
      "  g: {{type: gear, bodies: [wheel, pinion], at: [0, 2], tangent: x, pressure_angle: 0.3}}\n"
      "actuators: {{in: {{coupling: a}}, out: {{coupling: b}}}}\n"
      "losses: {{gear_external: 0.02}}\n"
      "cases: {{k: {{motion: {{in: 1}}, action: {{in: {}}}}}}}\n",
      torque);
}

// Sun of 100 teeth, planet of 99 and 100, fixed wheel of 100: i0 = 0.99, and η0 = 0.97.
std::string train_of_ratio_100(const std::string& given) {
  return fmt::format(
      "space: planar\n"
      "ground: housing\n"
      "bodies: [sun, carrier, planet]\n"
      "couplings:\n"
      "  a: {{type: revolute, bodies: [housing, sun], at: [0, 0]}}\n"
      "  c: {{type: revolute, bodies: [housing, carrier], at: [0, 0]}}\n"
      "  p: {{type: revolute, bodies: [carrier, planet], at: [0, 199]}}\n"
      "  s: {{type: gear, bodies: [sun, planet], at: [0, 100], tangent: x, pressure_angle: 0.3}}\n"
      "  w: {{type: gear, bodies: [housing, planet], at: [0, 99.5], tangent: x,\n"
      "       pressure_angle: 0.3}}\n"
      "actuators: {{sun: {{coupling: a}}, arm: {{coupling: c}}}}\n"
      "losses: {{meshes: {{s: 0.03}}}}\n"
      "cases: {{k: {{motion: {{sun: 1}}, action: {{{}}}}}}}\n",
      given);
}

// The teeth bear 50 N along x: 1 N·m of loss on the pinion.
TEST(LossyActions, HoldTheDrivenGearBack) {
  const Lossy pair(pair_of_gears(100.0));

  EXPECT_EQ(pair.found.search, LossSearch::found);
  ASSERT_EQ(pair.found.solution.friction.size(), 1U);
  EXPECT_EQ(pair.found.solution.friction[0].between->head, BodyId{2});
  EXPECT_EQ(pair.found.solution.friction[0].between->tail, BodyId{0});
  EXPECT_NEAR(pair.found.solution.friction[0].magnitude, 1.0, 1e-12);
  EXPECT_NEAR(std::abs(pair.action("out")), 49.0, 1e-12);
}

// Whatever else turns in the mechanism, and however fast.
TEST(LossyActions, HoldSlowGearsBackBesideAFastShaft) {
  std::string text = pair_of_gears(100.0);
  const auto put = [&](const std::string& before, const std::string& more) {
    text.insert(text.find(before), more);
  };
  put("wheel, pinion]\ncouplings", "shaft, ");
  put("  a: {type", "  f: {type: revolute, bodies: [frame, shaft], at: [9, 9]}\n");
  put("in: {coupling", "fast: {coupling: f}, ");
  put("in: 1}", "fast: 1e10, ");

  const Lossy pair(text);

  ASSERT_EQ(pair.losses.laws.size(), 1U);
  EXPECT_EQ(pair.found.search, LossSearch::found);
  ASSERT_EQ(pair.found.solution.friction.size(), 1U);
  EXPECT_NEAR(pair.found.solution.friction[0].magnitude, 1.0, 1e-12);
  EXPECT_NEAR(std::abs(pair.action("out")), 49.0, 1e-12);
}

// What the pinion gives is 100/0.98 W, of which 2 % are lost on the wheel at 1 rad/s.
TEST(LossyActions, FollowTheDirectionOfThePower) {
  const Lossy pair(pair_of_gears(-100.0));

  EXPECT_EQ(pair.found.search, LossSearch::found);
  ASSERT_EQ(pair.found.solution.friction.size(), 1U);
  EXPECT_EQ(pair.found.solution.friction[0].between->head, BodyId{1});
  EXPECT_NEAR(pair.found.solution.friction[0].magnitude, 2.0 / 0.98, 1e-12);
  EXPECT_NEAR(std::abs(pair.action("out")), 50.0 / 0.98, 1e-12);
}

TEST(LossyActions, AreThoseWithoutLossesWhereNothingActs) {
  const Lossy pair(pair_of_gears(0.0));

  EXPECT_EQ(pair.found.search, LossSearch::found);
  EXPECT_EQ(pair.action("out"), 0.0);
}

// Torque of the arm: -(1 - i0/η0) of the sun's, in which the sun drives the planet.
TEST(LossyActions, AreGivenThoughRejected) {
  const Lossy train(train_of_ratio_100("sun: 100"), true);

  EXPECT_EQ(train.found.search, LossSearch::rejected);
  EXPECT_NEAR(train.action("arm"), -100.0 * (1.0 - 0.99 / 0.97), 1e-9);
}

// A torque of the arm that asks for power from the sun: with either sense the sun gives none.
TEST(LossyActions, DoNotExistWhereNoSenseAgrees) {
  const Lossy train(train_of_ratio_100("arm: -100"));

  EXPECT_EQ(train.found.search, LossSearch::none);
  EXPECT_EQ(train.found.solution.status, SolveStatus::locked_by_friction);
  EXPECT_TRUE(train.found.solution.magnitudes.empty());
}

TEST(MeshLoss, IsNoneWhereTheTrainTurnsAsABlock) {
  const std::string free =
      "space: planar\n"
      "ground: housing\n"
      "bodies: [sun, carrier, planet]\n"
      "couplings:\n"
      "  a: {type: revolute, bodies: [housing, sun], at: [0, 0]}\n"
      "  c: {type: revolute, bodies: [housing, carrier], at: [0, 0]}\n"
      "  p: {type: revolute, bodies: [carrier, planet], at: [0, 3]}\n"
      "  s: {type: gear, bodies: [sun, planet], at: [0, 2], tangent: x,\n"
      "      pressure_angle: 0.3}\n"
      "actuators: {sun: {coupling: a}, arm: {coupling: c}}\n"
      "losses: {gear_external: 0.02}\n"
      "cases: {k: {motion: {sun: 1, arm: 1}, action: {sun: 0, arm: 0}}}\n";
  const Lossy block(free);

  EXPECT_TRUE(block.losses.laws.empty());
  EXPECT_EQ(block.losses.not_rolling, std::vector<CouplingId>{CouplingId{3}});
}

// The planet of radius 0.018 m stands at that angle between sun and ring; both turn alike.
std::string block_at(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  const auto at = [&](double radius) {
    return fmt::format("[{}, {}]", 0.1 + radius * std::cos(angle), 0.3 + radius * std::sin(angle));
  };
  const std::string teeth =
      fmt::format("tangent: [{}, {}], pressure_angle: 0.3", -std::sin(angle), std::cos(angle));
  return fmt::format(
      "space: planar\n"
      "ground: housing\n"
      "bodies: [sun, ring, carrier, planet]\n"
      "couplings:\n"
      "  a: {{type: revolute, bodies: [housing, sun], at: [0.1, 0.3]}}\n"
      "  b: {{type: revolute, bodies: [housing, ring], at: [0.1, 0.3]}}\n"
      "  c: {{type: revolute, bodies: [housing, carrier], at: [0.1, 0.3]}}\n"
      "  d: {{type: revolute, bodies: [carrier, planet], at: {}}}\n"
      "  e: {{type: gear, bodies: [sun, planet], at: {}, {}}}\n"
      "  f: {{type: gear, bodies: [ring, planet], at: {}, {}, internal: true}}\n"
      "actuators: {{sun: {{coupling: a}}, ring: {{coupling: b}}}}\n"
      "losses: {{gear_external: 0.02, gear_internal: 0.01}}\n"
      "cases: {{k: {{motion: {{sun: 10.47, ring: 10.47}}}}}}\n",
      at(0.042),
      at(0.024),
      teeth,
      at(0.06),
      teeth);
}

TEST(MeshLoss, IsNoneWhereverThePlanetOfABlockIs) {
  for (int degrees = 1; degrees <= 90; ++degrees) {
    const Mechanism mechanism = mechanism_of(block_at(degrees));
    const KinematicSolution motion =
        solve_velocity(mechanism,
                       motion_basis(mechanism.geometry, OrderChoice::minimal),
                       mechanism.cases.front().motions);

    EXPECT_EQ(find_mesh_loss_laws(mechanism, motion).not_rolling.size(), 2U) << degrees;
  }
}

TEST(MeshLoss, NeedsACarrier) {
  const Lossy pair(
      "space: planar\n"
      "ground: frame\n"
      "bodies: [wheel, pinion]\n"
      "couplings:\n"
      "  a: {type: revolute, bodies: [frame, wheel], at: [0, 0]}\n"
      "  b: {type: screws, bodies: [frame, pinion],\n"
      "      freedoms: [{rotation: [0, 0, 1], at: [0, 3]}]}\n"
      "  g: {type: gear, bodies: [wheel, pinion], at: [0, 2], tangent: x, pressure_angle: 0.3}\n"
      "actuators: {in: {coupling: a}, out: {coupling: b}}\n"
      "losses: {gear_external: 0.02}\n"
      "cases: {k: {motion: {in: 1}, action: {in: 100}}}\n");

  EXPECT_EQ(pair.losses.without_carrier, std::vector<CouplingId>{CouplingId{2}});
}

}  // namespace
}  // namespace kinestat
