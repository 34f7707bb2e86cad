// Actions under loads, against closed forms worked out beside each test.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "network/bases.hpp"
#include "screw/screw_axis.hpp"
#include "statics/action.hpp"
#include "support/mechanism_text.hpp"
#include "support/near.hpp"
#include "unit/statics/magnitude.hpp"

namespace kinestat {
namespace {

// The first case of the mechanism, as the program solves it.
StaticSolution solve_loaded(const Mechanism& mechanism) {
  const std::vector<BodyWrench> loads = wrenches_of(mechanism.cases.at(0).loads);
  return solve_action(mechanism,
                      action_basis(mechanism.geometry, mechanism.static_order, loads),
                      mechanism.cases[0].actions,
                      loads);
}

// A beam of 4 m from a pin at the origin to a roller, which is a pin on a slider.
std::string beam(const std::string& body, const std::string& sections) {
  return "space: planar\nground: base\nbodies: {beam: " + body +
         ", roller: }\ncouplings:\n"
         "  pin: {type: revolute, bodies: [base, beam], at: [0, 0]}\n"
         "  end: {type: revolute, bodies: [roller, beam], at: [4, 0]}\n"
         "  roll: {type: prismatic, bodies: [base, roller], at: [4, 0], axis: x}\n" +
         sections;
}

TEST(LoadedAction, OfASimpleBeamIsInTheInverseRatioOfTheDistances) {
  const Mechanism mechanism = mechanism_of(beam(
      "", "loads: {push: {body: beam, at: [1, 0], force: [5, -8]}}\ncases: {one: {action: {}}}\n"));

  const StaticSolution solution = solve_loaded(mechanism);

  // A load P at a of a beam l: P (l - a)/l on the near support, P a/l on the far one. The pin alone
  // bears what acts along the beam.
  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "pin.Rx"), -5.0, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "pin.Ry"), 8.0 * 3.0 / 4.0, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "roll.Ry"), 8.0 * 1.0 / 4.0, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "roll.Tz"), 0.0, 1e-13);
}

TEST(LoadedAction, OfASimpleBeamHoldsACoupleByAPairOfForces) {
  const Mechanism mechanism = mechanism_of(
      beam("", "loads: {twist: {body: beam, couple: 12}}\ncases: {one: {action: {}}}\n"));

  const StaticSolution solution = solve_loaded(mechanism);

  // C/l down at the far end, up at the near one: 4 m · (-3 N) + 12 N·m = 0.
  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "pin.Ry"), 3.0, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "end.Ry"), -3.0, 1e-13);
}

TEST(LoadedAction, OfWeightIsSharedByTheSupports) {
  const Mechanism mechanism = mechanism_of(beam(
      "{mass: 10, centre_of_mass: [3, 0]}", "gravity: [0, -9.81]\ncases: {one: {action: {}}}\n"));

  const StaticSolution solution = solve_loaded(mechanism);

  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "pin.Ry"), 98.1 / 4.0, 1e-12);
  EXPECT_NEAR(magnitude(mechanism, solution, "roll.Ry"), 98.1 * 3.0 / 4.0, 1e-12);
}

TEST(LoadedAction, HoldsAPendulumByTheMomentOfItsWeight) {
  const Mechanism mechanism = mechanism_of(
      "space: planar\nground: base\n"
      "bodies: {rod: {mass: 2, centre_of_mass: [0.6 m*sin(30 deg), -0.6 m*cos(30 deg)]}}\n"
      "couplings: {a: {type: revolute, bodies: [base, rod], at: [0, 0]}}\n"
      "actuators: {motor: {coupling: a}}\ngravity: [0, -10]\ncases: {one: {action: {}}}\n");

  const StaticSolution solution = solve_loaded(mechanism);

  // m g l sin θ = 2 · 10 · 0.6 · 1/2, anticlockwise, against the pull back.
  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "motor"), 6.0, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "a.Ry"), 20.0, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "a.Rx"), 0.0, 1e-13);
}

// With ω = 1 rad/s of the crank: v_b = (-3, 1); the coupler turns with -8/27 rad/s, for
// v_c = v_b + ω (-2, 5) = (-5, -1) ω_rocker. So P = (3, 5) on it moves with
// v_b - 8/27 (-2, 2) = (-65, 11)/27 m/s.
TEST(LoadedAction, OfAFourBarLinkageDoesTheVirtualWorkOfTheLoad) {
  const Mechanism mechanism = mechanism_of(
      "space: planar\nground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
      "  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}\n"
      "  b: {type: revolute, bodies: [crank, coupler], at: [1, 3]}\n"
      "  c: {type: revolute, bodies: [coupler, rocker], at: [6, 5]}\n"
      "  d: {type: revolute, bodies: [frame, rocker], at: [7, 0]}\n"
      "actuators: {drive: {coupling: a}}\n"
      "loads: {pull: {body: coupler, at: [3, 5], force: [2, -7], couple: 4}}\n"
      "cases: {one: {action: {}}}\n");

  const StaticSolution solution = solve_loaded(mechanism);

  // The power of the load is (2, -7) · (-65, 11)/27 + 4 · (-8/27) = -239/27 W.
  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "drive"), 239.0 / 27.0, 1e-12);
}

// A door 2 m high and 1 m wide, its hinges on the z axis; only the lower one bears its weight.
TEST(LoadedAction, OfADoorsHingesIsAPairOfForcesAgainstItsWeight) {
  const Mechanism mechanism = mechanism_of(
      "ground: wall\nbodies: {door: {mass: 30, centre_of_mass: [0.5, 0, 1]}}\ncouplings:\n"
      "  low: {type: revolute, bodies: [wall, door], at: [0, 0, 0.2], axis: z, passive: [Rx, Ry, "
      "Rz]}\n"
      "  high: {type: revolute, bodies: [wall, door], at: [0, 0, 1.7], axis: z, passive: [Rx, "
      "Ry]}\n"
      "gravity: [0, 0, -10]\n"
      "cases: {one: {action: {}}}\n");

  const StaticSolution solution = solve_loaded(mechanism);

  // m g · 0.5 m = 150 N·m by hinges 1.5 m apart.
  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "low.Rz"), 300.0, 1e-11);
  EXPECT_NEAR(magnitude(mechanism, solution, "low.Rx"), 100.0, 1e-11);
  EXPECT_NEAR(magnitude(mechanism, solution, "high.Rx"), -100.0, 1e-11);
  EXPECT_NEAR(magnitude(mechanism, solution, "high.Ry"), 0.0, 1e-11);
}

TEST(LoadedAction, MeetsPrimaryActionsThatAgreeWithTheLoad) {
  const Mechanism mechanism =
      mechanism_of(beam("",
                        "loads: {push: {body: beam, at: [1, 0], force: [0, -8]}}\n"
                        "cases: {one: {action: {roll.Ry: 2}}}\n"));

  const StaticSolution solution = solve_loaded(mechanism);

  EXPECT_EQ(solution.status, SolveStatus::dependent);
  ASSERT_EQ(solution.check.dependences.size(), 1U);
  const Dependence& dependence = solution.check.dependences[0];
  ASSERT_EQ(dependence.terms.size(), 1U);
  EXPECT_NEAR(dependence.constant / dependence.terms[0].coefficient, 2.0, 1e-13);
}

TEST(LoadedAction, MeetsPrimaryActionsThatContradictTheLoad) {
  const Mechanism mechanism =
      mechanism_of(beam("",
                        "loads: {push: {body: beam, at: [1, 0], force: [0, -8]}}\n"
                        "cases: {one: {action: {roll.Ry: 2.001}}}\n"));

  const StaticSolution solution = solve_loaded(mechanism);

  EXPECT_EQ(solution.status, SolveStatus::inconsistent);
  EXPECT_EQ(solution.check.dependences.size(), 1U);
  EXPECT_TRUE(solution.magnitudes.empty());
}

const std::string kSliders =
    "ground: base\nbodies: [first, second]\ncouplings:\n"
    "  a: {type: prismatic, bodies: [base, first], at: [1, 0, 0], axis: x}\n"
    "  b: {type: prismatic, bodies: [base, second], at: [0, 2, 0], axis: y}\n"
    "actuators: {p: {coupling: a}}\n";

TEST(LoadedAction, AlongAFreedomThatNothingResistsIsInconsistent) {
  const Mechanism mechanism = mechanism_of(
      kSliders +
      "loads: {one: {body: first, at: [1, 0, 0], force: [1, 1, 1]}, two: {body: second, at: [0, 2, "
      "0], force: [1, 5, 1]}}\ncases: {one: {action: {}}}\n");

  const StaticSolution solution = solve_loaded(mechanism);

  // The first is held by the actuator and its guide, the second only by its guide.
  EXPECT_EQ(solution.status, SolveStatus::inconsistent);
  EXPECT_TRUE(solution.check.dependences.empty());
  ASSERT_TRUE(solution.unconstrained.has_value());
  EXPECT_EQ(solution.unconstrained->body, BodyId{2});
  EXPECT_EQ(solution.unconstrained->loads, std::vector<int>{1});
  EXPECT_TRUE(
      is_near(solution.unconstrained->twist.linear.cwiseAbs().normalized(), Vec3::UnitY(), kTight));
  EXPECT_TRUE(is_near(solution.unconstrained->twist.angular, Vec3::Zero(), kTight));
}

TEST(LoadedAction, AcrossAFreedomThatNothingResistsIsSolved) {
  const Mechanism mechanism =
      mechanism_of(kSliders +
                   "loads: {two: {body: second, at: [0, 2, 0], force: [3, 0, 4]}}\n"
                   "cases: {one: {action: {}}}\n");

  const StaticSolution solution = solve_loaded(mechanism);

  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "b.Rx"), -3.0, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "b.Rz"), -4.0, 1e-13);
}

// Bearings that take only forces along x and y: nothing of the network resists Fz.
const std::string kFloating =
    "ground: base\nbodies: [shaft]\ncouplings:\n"
    "  a: {type: revolute, bodies: [base, shaft], at: [0, 0, 0], axis: z, passive: [Rx, Ry]}\n"
    "  b: {type: revolute, bodies: [base, shaft], at: [0, 0, 2], axis: z, passive: [Rx, Ry]}\n";

TEST(LoadedAction, BesideTheMinimalOrderIsNotOverlooked) {
  const Mechanism mechanism =
      mechanism_of(kFloating +
                   "loads: {thrust: {body: shaft, at: [0, 0, 1], force: [1, 0, 5]}}\n"
                   "cases: {one: {action: {}}}\n");
  ASSERT_EQ(action_basis(mechanism.geometry, OrderChoice::minimal).order(), 4);

  const StaticSolution solution = solve_loaded(mechanism);

  EXPECT_EQ(solution.status, SolveStatus::inconsistent);
  ASSERT_TRUE(solution.unconstrained.has_value());
  const auto axis = find_axis(solution.unconstrained->twist, mechanism.geometry.length);
  ASSERT_TRUE(axis.has_value());
  EXPECT_FALSE(axis->pitch.has_value());
  EXPECT_TRUE(is_near(axis->direction.cwiseAbs(), Vec3::UnitZ(), kTight));
}

TEST(LoadedAction, BesideTheMinimalOrderMayCancel) {
  const Mechanism mechanism = mechanism_of(
      kFloating +
      "loads: {up: {body: shaft, at: [0, 0, 1], force: [6, 0, 5]}, down: {body: shaft, "
      "at: [0, 0, 0], force: [0, 0, -5]}}\ncases: {one: {action: {}}}\n");

  const StaticSolution solution = solve_loaded(mechanism);

  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_EQ(solution.counts.order, 6);
  EXPECT_NEAR(magnitude(mechanism, solution, "a.Rx"), -3.0, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "b.Rx"), -3.0, 1e-13);
}

TEST(LoadedAction, TooLargeToBeComputedWithIsSaidSo) {
  const Mechanism mechanism =
      mechanism_of(beam("",
                        "loads: {push: {body: beam, at: [1, 0], force: [0, 1e150]},\n"
                        "        more: {body: beam, at: [1, 0], force: [0, 1e150]}}\n"
                        "cases: {one: {action: {}}}\n"));

  EXPECT_EQ(solve_loaded(mechanism).status, SolveStatus::overflow);
}

}  // namespace
}  // namespace kinestat
