// Derivatives of actions that stiffness or the least norm determines.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sensitivity/solved_case.hpp"
#include "unit/sensitivity/slope.hpp"

namespace kinestat {
namespace {

// A shaft between two bearings that bear its thrust like springs in parallel.
const std::string kShaft =
    "kinestat: 1\n"
    "parameters: {left: 3e7, right: 1e7, F: 800, x: 0.5}\n"
    "statics: {indeterminate: stiffness}\n"
    "ground: base\n"
    "bodies: [shaft]\n"
    "couplings:\n"
    "  a: {type: revolute, bodies: [base, shaft], at: [0, 0, 0], axis: x, passive: [Rx, Ry, Rz],"
    " stiffness: {Rx: left}}\n"
    "  b: {type: revolute, bodies: [base, shaft], at: [2, 0, 0], axis: x, passive: [Rx, Ry, Rz],"
    " stiffness: {Rx: right}}\n"
    "loads: {push: {body: shaft, at: [x, 0, 0], force: [F, F, 0]}}\n"
    "cases: {k: {action: {}}}\n";

// Each spring bears F k/Σk, against the load.
TEST(Stiffness, HasTheDerivativesOfSpringsInParallel) {
  const double sum = 4e7;
  const Slopes slopes = Solved(kShaft).derivatives_of("a.Rx");

  EXPECT_NEAR(slope(slopes, 0), -800.0 * 1e7 / (sum * sum), 1e-19);
  EXPECT_NEAR(slope(slopes, 1), 800.0 * 3e7 / (sum * sum), 1e-19);
  EXPECT_NEAR(slope(slopes, 2), -0.75, 1e-15);
  EXPECT_EQ(slope(slopes, 3), 0.0);
}

TEST(Stiffness, MovesTheWrenchOfItsCouplingButNotWhatEquilibriumDetermines) {
  const Solved solved(kShaft);
  const Slopes force = solved.derivatives_of("statics/couplings/b/force/0");
  const Slopes across = solved.derivatives_of("statics/couplings/b/force/1");

  EXPECT_NEAR(slope(force, 0), 800.0 * 1e7 / (4e7 * 4e7), 1e-19);
  EXPECT_NEAR(slope(force, 2), -0.25, 1e-15);
  EXPECT_EQ(slope(across, 0), 0.0);
  EXPECT_NEAR(slope(across, 2), -0.25, 1e-15);
  EXPECT_NEAR(slope(across, 3), -400.0, 1e-12);
}

// The middle of three bars that meet in a knot, at an angle t between them: of one material it
// bears P/(1 + 2 c³ E_s/E_m), c = cos t (Timoshenko, Strength of Materials, part I).
TEST(Stiffness, HasTheDerivativesOfTheThreeBarTruss) {
  const Solved solved(
      "kinestat: 1\n"
      "space: planar\n"
      "parameters: {high: 0.6, wide: 0.8, side: 2e7, middle: 3e7, P: 900, all: 1, knot: 0}\n"
      "statics: {indeterminate: stiffness}\n"
      "ground: ceiling\n"
      "bodies: [knot]\n"
      "couplings:\n"
      "  l: {type: cable, bodies: [ceiling, knot], from: [-wide, high], to: [0, 0],"
      " stiffness: {F: all*side/sqrt(high^2 + wide^2)}}\n"
      "  m: {type: cable, bodies: [ceiling, knot], from: [0, high], to: [0, 0],"
      " stiffness: {F: all*middle/high}}\n"
      "  r: {type: cable, bodies: [ceiling, knot], from: [wide, high], to: [0, 0],"
      " stiffness: {F: all*side/sqrt(high^2 + wide^2)}}\n"
      "loads: {weight: {body: knot, at: [knot, 0], force: [0, -P]}}\n"
      "cases: {k: {action: {}}}\n");
  const Slopes slopes = solved.derivatives_of("m.F");

  const double c = 0.6;  // of bars of 1 m
  const double ratio = 2.0 / 3.0;
  const double share = 1.0 / (1.0 + 2.0 * c * c * c * ratio);
  const double by_c = -900.0 * 6.0 * c * c * ratio * share * share;
  const double by_ratio = -900.0 * 2.0 * c * c * c * share * share;
  EXPECT_NEAR(slope(slopes, 0), by_c * 0.8 * 0.8, 1e-10);
  EXPECT_NEAR(slope(slopes, 1), by_c * -0.6 * 0.8, 1e-10);
  EXPECT_NEAR(slope(slopes, 2), by_ratio / 3e7, 1e-18);
  EXPECT_NEAR(slope(slopes, 3), by_ratio * -ratio / 3e7, 1e-18);
  EXPECT_NEAR(slope(slopes, 4), share, 1e-14);
  EXPECT_NEAR(slope(slopes, 5), 0.0, 1e-10);  // all stiffnesses together
  EXPECT_FALSE(slopes.at(6).has_value());     // nothing keeps the knot from turning
}

// A table on four springs k at (±a, ±b): leg i bears W/4 (1 + x x0/a² + y y0/b²). If leg 1 alone
// grows stiffer it takes 1/(4k) of what it bears from legs 2 and 4, and gives it to leg 3: with
// the self-stress X (1, -1, 1, -1), X = -R1 (1/k1 - 1/k)/(1/k1 + 3/k).
TEST(Stiffness, HasTheDerivativesOfATableOnFourLegs) {
  const Solved solved(
      "kinestat: 1\n"
      "parameters: {a: 0.6, b: 0.4, weight: 160, x0: 0.15, first: 5e4, others: 5e4}\n"
      "statics: {indeterminate: stiffness}\n"
      "ground: floor\n"
      "bodies: [table]\n"
      "couplings:\n"
      "  one: {type: point_contact, bodies: [floor, table], at: [a, b, 0], normal: z,"
      " stiffness: {Rz: first}}\n"
      "  two: {type: point_contact, bodies: [floor, table], at: [a, -b, 0], normal: z,"
      " stiffness: {Rz: others}}\n"
      "  three: {type: point_contact, bodies: [floor, table], at: [-a, -b, 0], normal: z,"
      " stiffness: {Rz: others}}\n"
      "  four: {type: point_contact, bodies: [floor, table], at: [-a, b, 0], normal: z,"
      " stiffness: {Rz: others}}\n"
      "loads: {weight: {body: table, at: [x0, 0.1, 0.7], force: [0, 0, -weight]}}\n"
      "cases: {k: {action: {}}}\n");
  const Slopes one = solved.derivatives_of("one.Rz");
  const Slopes two = solved.derivatives_of("two.Rz");

  EXPECT_NEAR(slope(one, 0), -40.0 * 0.15 / 0.36, 1e-12);
  EXPECT_NEAR(slope(one, 1), -40.0 * 0.1 / 0.16, 1e-12);
  EXPECT_NEAR(slope(one, 2), 0.25 * 1.5, 1e-14);
  EXPECT_NEAR(slope(one, 3), 40.0 / 0.6, 1e-12);
  EXPECT_NEAR(slope(one, 4), 60.0 / (4.0 * 5e4), 1e-17);
  EXPECT_NEAR(slope(one, 5), -60.0 / (4.0 * 5e4), 1e-17);
  EXPECT_NEAR(slope(two, 4), -60.0 / (4.0 * 5e4), 1e-17);
  EXPECT_NEAR(slope(two, 3), 40.0 / 0.6, 1e-12);
}

// A beam on pins, one of them above the others by `up`. Along the beam nothing is elastic.
std::string pinned_beam() {
  return "kinestat: 1\n"
         "space: planar\n"
         "parameters: {up: 0, k: 2e6, F: 700, x: 1}\n"
         "statics: {indeterminate: stiffness}\n"
         "ground: base\n"
         "bodies: [beam]\n"
         "couplings:\n"
         "  a: {type: revolute, bodies: [base, beam], at: [0, 0], stiffness: {Ry: 1e6}}\n"
         "  b: {type: revolute, bodies: [base, beam], at: [1, up], stiffness: {Ry: k}}\n"
         "  c: {type: revolute, bodies: [base, beam], at: [3, 0], passive: [Ry],"
         " stiffness: {Ry: 4e6}}\n"
         "loads: {push: {body: beam, at: [x, 0], force: [9, -F]}}\n"
         "cases: {k: {action: {}}}\n";
}

// The beam sinks by α + β x, Σk α + Σkx β = F and Σkx α + Σkx² β = F x, so that b bears
// F k (24 - 7 x)/(36 + 17 k), k in MN/m.
TEST(Stiffness, DifferentiatesBesideWhatStaysOpen) {
  const Solved solved(pinned_beam());
  const Slopes slopes = solved.derivatives_of("b.Ry");

  EXPECT_FALSE(find_reported_value(solved.values(), "b.Rx").has_value());
  EXPECT_NEAR(slope(slopes, 1), 700.0 * 17.0 * 36.0 / (70.0 * 70.0) * 1e-6, 1e-16);
  EXPECT_NEAR(slope(slopes, 2), 34.0 / 70.0, 1e-14);
  EXPECT_NEAR(slope(slopes, 3), -140.0, 1e-11);
}

// Once the pins are not level, what is rigid along the beam keeps it from tilting: a jump.
TEST(Stiffness, HasNoDerivativeWhereRigidActionsBeginToBind) {
  const Slopes slopes = Solved(pinned_beam()).derivatives_of("b.Ry");

  EXPECT_FALSE(slopes.at(0).has_value());
}

// A block between slides at 0 and L, loaded by F at x: of all actions in equilibrium the least
// R1² + R2² + (T1² + T2²)/L² has T = 2/5 F (x - L/2) twice, and R2 = F/2 + F/5 (x/L - 1/2).
std::string slides(std::string_view at) {
  return fmt::format(
      "kinestat: 1\n"
      "space: planar\n"
      "parameters: {{L: 4, x: 3, F: 8, e: 0}}\n"
      "statics: {{indeterminate: minimum_norm}}\n"
      "ground: base\n"
      "bodies: [block, post]\n"
      "couplings:\n"
      "  a: {{type: prismatic, bodies: [base, block], at: [0, 0], axis: x}}\n"
      "  b: {{type: prismatic, bodies: [base, block], at: [L, 0], axis: x}}\n"
      "  c: {{type: prismatic, bodies: [base, post], at: [{}, 0], axis: x}}\n"
      "loads: {{push: {{body: block, at: [x, 0], force: [0, -F]}}}}\n"
      "cases: {{k: {{action: {{}}}}}}\n",
      at);
}

TEST(MinimumNorm, CountsThatItsLengthMoves) {
  const Solved solved(slides("1 + e"));
  const Slopes couple = solved.derivatives_of("a.Tz");
  const Slopes force = solved.derivatives_of("b.Ry");

  EXPECT_NEAR(slope(couple, 0), -8.0 / 5.0, 1e-13);
  EXPECT_NEAR(slope(couple, 1), 2.0 / 5.0 * 8.0, 1e-13);
  EXPECT_NEAR(slope(couple, 2), 2.0 / 5.0, 1e-14);
  EXPECT_EQ(slope(couple, 3), 0.0);
  EXPECT_NEAR(slope(force, 0), -8.0 / 5.0 * 3.0 / 16.0, 1e-14);
  EXPECT_NEAR(slope(force, 1), 8.0 / 5.0 / 4.0, 1e-14);
}

// Post c, if it stands at the end of the box, makes it longer when it moves out, not shorter when
// it moves in.
TEST(MinimumNorm, HasNoDerivativeAtACornerOfItsLength) {
  const Slopes slopes = Solved(slides("L + e")).derivatives_of("a.Tz");

  EXPECT_NEAR(slope(slopes, 0), -8.0 / 5.0, 1e-13);
  EXPECT_FALSE(slopes.at(3).has_value());
}

// A block drags a tool through two springs in parallel; P presses the tool on its guide, where it
// rubs. A spring at e > 0 would tilt the tool, and so rub as well.
std::string dragged_tool(double press_at, std::string_view length) {
  return fmt::format(
      "kinestat: 1\n"
      "space: planar\n"
      "parameters: {{mu: 0.3, P: 50, k: 3e4, e: 0, v: 0.1}}\n"
      "statics: {{indeterminate: stiffness}}\n"
      "ground: bed\n"
      "bodies: [block, tool]\n"
      "couplings:\n"
      "  d: {{type: prismatic, bodies: [bed, block], at: [0, 0], axis: x}}\n"
      "  g: {{type: prismatic, bodies: [bed, tool], at: [1, 0], axis: x,"
      " friction: {{mu: mu{}}}}}\n"
      "  p: {{type: point_contact, bodies: [block, tool], at: [0.5, 0], normal: x,"
      " stiffness: {{Rx: k}}}}\n"
      "  q: {{type: point_contact, bodies: [block, tool], at: [0.6, e], normal: x,"
      " stiffness: {{Rx: 2e4}}}}\n"
      "actuators: {{drive: {{coupling: d}}}}\n"
      "loads: {{press: {{body: tool, at: [{}, 0], force: [0, -P]}}}}\n"
      "cases: {{k: {{motion: {{drive: v}}, action: {{}}}}}}\n",
      length,
      press_at);
}

TEST(Stiffness, SharesFrictionThatParametersMove) {
  const Solved solved(dragged_tool(1.0, ""));
  const Slopes spring = solved.derivatives_of("p.Rx");
  const Slopes power = solved.derivatives_of("power/couplings/p");
  const Slopes drive = solved.derivatives_of("drive");

  EXPECT_NEAR(slope(spring, 0), 50.0 * 0.6, 1e-13);
  EXPECT_NEAR(slope(spring, 1), 0.3 * 0.6, 1e-14);
  EXPECT_NEAR(slope(spring, 2), 15.0 * 2e4 / (5e4 * 5e4), 1e-17);
  EXPECT_EQ(slope(spring, 4), 0.0);
  EXPECT_NEAR(slope(power, 2), 0.1 * 15.0 * 2e4 / (5e4 * 5e4), 1e-18);
  EXPECT_NEAR(slope(power, 4), 15.0 * 0.6, 1e-13);
  EXPECT_NEAR(slope(drive, 0), 50.0, 1e-13);
  EXPECT_EQ(slope(drive, 2), 0.0);
}

// P at 0.3 m beside a guide of 0.2 m presses its ends with P/2 ± 1.5 P: 3 P together.
TEST(Stiffness, HasNoDerivativeWhereASelfStressBeginsToRub) {
  const Slopes slopes = Solved(dragged_tool(1.3, ", length: 0.2")).derivatives_of("p.Rx");

  EXPECT_NEAR(slope(slopes, 0), 150.0 * 0.6, 1e-12);
  EXPECT_NEAR(slope(slopes, 1), 0.9 * 0.6, 1e-14);
  EXPECT_FALSE(slopes.at(3).has_value());
}

// Two motors hold a wheel against F r: each a half, by convention.
const std::string kTwoMotors =
    "kinestat: 1\n"
    "space: planar\n"
    "parameters: {r: 0.2, F: 30, w: 4 rad/s}\n"
    "statics: {indeterminate: minimum_norm}\n"
    "ground: base\n"
    "bodies: [wheel]\n"
    "couplings:\n"
    "  a: {type: revolute, bodies: [base, wheel], at: [0, 0]}\n"
    "  b: {type: revolute, bodies: [base, wheel], at: [0, 0]}\n"
    "actuators: {one: {coupling: a}, two: {coupling: b}}\n"
    "loads: {rim: {body: wheel, at: [r, 0], force: [0, -F]}}\n"
    "cases: {k: {motion: {one: w}, action: {}}}\n";

TEST(MinimumNorm, IsNoPower) {
  const Solved solved(kTwoMotors);

  EXPECT_NEAR(slope(solved.derivatives_of("one"), 0), 15.0, 1e-13);
  EXPECT_NEAR(slope(solved.derivatives_of("one"), 1), 0.1, 1e-15);
  EXPECT_FALSE(find_reported_value(solved.values(), "power/actuators/one").has_value());
  EXPECT_FALSE(find_reported_value(solved.values(), "power/input").has_value());
}

}  // namespace
}  // namespace kinestat
