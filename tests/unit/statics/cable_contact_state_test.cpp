#include "statics/cable_contact_state.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "network/bases.hpp"
#include "statics/action.hpp"
#include "support/mechanism_text.hpp"

namespace kinestat {
namespace {

constexpr double kClose = 1e-12;

// A cable with half a turn around a fixed drum; a brake on the virtual link holds it.
CableContactState held(double mu, double before, double after) {
  const Mechanism mechanism = mechanism_of(
      fmt::format("space: planar\n"
                  "ground: frame\n"
                  "bodies: [first, last]\n"
                  "couplings:\n"
                  "  a: {{type: prismatic, bodies: [frame, first], axis: y}}\n"
                  "  b: {{type: prismatic, bodies: [frame, last], axis: y}}\n"
                  "cables:\n"
                  "  rope:\n"
                  "    over:\n"
                  "      - {{body: first, at: [-1, -9]}}\n"
                  "      - {{pulley: frame, at: [0, 0], radius: 1, wrap: clockwise, slip: true,\n"
                  "         friction: {}}}\n"
                  "      - {{body: last, at: [1, -9]}}\n"
                  "actuators: {{A: {{coupling: a}}, B: {{coupling: b}}, grip: {{coupling: "
                  "rope_frame}}}}\n"
                  "cases: {{one: {{action: {{rope_1.F: {}, rope_2.F: {}}}}}}}\n",
                  mu,
                  before,
                  after));
  const StaticSolution solution =
      solve_action(mechanism,
                   action_basis(mechanism.geometry, OrderChoice::minimal, {}),
                   mechanism.cases.front().actions,
                   {});
  EXPECT_EQ(solution.status, SolveStatus::solved);
  return find_cable_contact_states(mechanism, solution, nullptr).at(0);
}

TEST(CableContactState, SticksUpToTheLimitOfEulerAndEytelwein) {
  const double limit = std::exp(0.3 * std::numbers::pi);

  const CableContactState at_limit = held(0.3, 10.0, 10.0 * limit);

  EXPECT_NEAR(at_limit.limit.value_or(0.0), limit, kClose);
  EXPECT_NEAR(at_limit.ratio.value_or(0.0), limit, kClose);
  EXPECT_EQ(at_limit.belt_state, BeltState::sticking);
  EXPECT_EQ(held(0.3, 10.0 * limit, 10.0).belt_state, BeltState::sticking);
}

TEST(CableContactState, WouldSlipBeyondTheLimit) {
  const double limit = std::exp(0.3 * std::numbers::pi);

  EXPECT_EQ(held(0.3, 10.0, 10.001 * limit).belt_state, BeltState::beyond_limit);
  EXPECT_EQ(held(0.3, 10.001 * limit, 10.0).belt_state, BeltState::beyond_limit);
}

TEST(CableContactState, HasNoRatioWhereTheRopeIsSlack) {
  const CableContactState state = held(0.3, 0.0, 10.0);

  EXPECT_FALSE(state.ratio);
  EXPECT_EQ(state.belt_state, BeltState::beyond_limit);
}

TEST(CableContactState, IsUnknownWithoutMotionOnlyInItsSlip) {
  const CableContactState state = held(0.3, 10.0, 11.0);

  EXPECT_FALSE(state.slip_speed);
  EXPECT_FALSE(state.slip_power);
  EXPECT_EQ(state.belt_state, BeltState::sticking);
}

}  // namespace
}  // namespace kinestat
