#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sensitivity/solved_case.hpp"
#include "unit/sensitivity/slope.hpp"

namespace kinestat {
namespace {

// A screw that turns in the base lifts a nut against the load F. The constraints that turn with the
// axis stay open, but one tilt moves all of them together.
std::string jack(double speed) {
  return fmt::format(
      "kinestat: 1\n"
      "parameters: {{mu: 0.15, r: 0.02, lead: 0.006, F: 7, tilt: 0.3 rad}}\n"
      "ground: base\n"
      "bodies: [screw, nut]\n"
      "couplings:\n"
      "  b: {{type: revolute, bodies: [base, screw], at: [0, 0, 0], axis: [sin(tilt), 0, "
      "cos(tilt)]}}\n"
      "  t: {{type: helical, bodies: [screw, nut], at: [0, 0, 0], axis: [sin(tilt), 0, "
      "cos(tilt)],\n"
      "      lead: -lead, friction: {{mu: mu, radius: r}}}}\n"
      "  g: {{type: prismatic, bodies: [base, nut], at: [1, 0, 1], axis: [sin(tilt), 0, "
      "cos(tilt)]}}\n"
      "actuators: {{crank: {{coupling: b}}, lift: {{coupling: g}}}}\n"
      "cases: {{k: {{motion: {{lift: {}}}, action: {{lift: -F}}, input: crank, output: lift}}}}\n",
      speed);
}

// T = F r tan(λ ± φ) with tan λ = h/r and tan φ = μ (Shigley's Mechanical Engineering Design,
// section 8-2), so with the share s = sec²(λ ± φ) of the angles:
// dT/dμ = ±F r s/(1 + μ²), dT/dh = F s/(1 + h²/r²), dT/dr = F tan(λ ± φ) - F s (h/r)/(1 + h²/r²).
TEST(ScrewJack, HasTheDerivativesOfItsClosedForm) {
  const double mu = 0.15;
  const double r = 0.02;
  const double h = 0.006 / (2.0 * M_PI);
  const double force = 7.0;
  for (const double sign : {1.0, -1.0}) {
    const double angle = std::atan(h / r) + sign * std::atan(mu);
    const double s = 1.0 + std::tan(angle) * std::tan(angle);
    const double by_lead = 1.0 / (1.0 + h * h / (r * r));
    const Slopes slopes = Solved(jack(0.01 * sign)).derivatives_of("crank");

    EXPECT_NEAR(slope(slopes, 0), sign * force * r * s / (1.0 + mu * mu), 1e-14);
    EXPECT_NEAR(slope(slopes, 1), force * (std::tan(angle) - s * h / r * by_lead), 1e-13);
    EXPECT_NEAR(slope(slopes, 2), force * s * by_lead / (2.0 * M_PI), 1e-13);
    EXPECT_NEAR(slope(slopes, 3), r * std::tan(angle), 1e-15);
    EXPECT_NEAR(slope(slopes, 4), 0.0, 1e-14);
  }
}

// η = tan λ / tan(λ + φ).
TEST(ScrewJack, HasTheDerivativesOfItsEfficiency) {
  const double mu = 0.15;
  const double lead = std::atan(0.006 / (2.0 * M_PI) / 0.02);
  const double tangent = std::tan(lead + std::atan(mu));
  const Slopes slopes = Solved(jack(0.01)).derivatives_of("power/efficiency/friction");

  EXPECT_NEAR(slope(slopes, 0),
              -std::tan(lead) * (1.0 + tangent * tangent) / (tangent * tangent * (1.0 + mu * mu)),
              1e-13);
  EXPECT_EQ(slope(slopes, 3), 0.0);
}

// The plunger presses at -b, a load Q at a; the journal bears their sum:
// P b = Q a + μ r (P + Q), P = Q (a + μ r)/(b - μ r).
TEST(JournalLever, HasTheDerivativesOfItsClosedForm) {
  const double mu = 0.3;
  const double r = 0.05;
  const double a = 0.7;
  const double b = 0.4;
  const double load = 11.0;
  const Slopes slopes =
      Solved(
          "kinestat: 1\n"
          "space: planar\n"
          "parameters: {mu: 0.3, r: 0.05, a: 0.7, b: 0.4, Q: 11}\n"
          "ground: f\n"
          "bodies: [lever, plunger]\n"
          "couplings:\n"
          "  j: {type: revolute, bodies: [f, lever], at: [0, 0], friction: {mu: mu, radius: r}}\n"
          "  c: {type: point_contact, bodies: [plunger, lever], at: [-b, 0], normal: y}\n"
          "  g: {type: prismatic, bodies: [f, plunger], at: [-b, 1], axis: y}\n"
          "actuators: {press: {coupling: g}}\n"
          "loads: {w: {body: lever, at: [a, 0], force: [0, -Q]}}\n"
          "cases: {k: {motion: {press: -0.1}}}\n")
          .derivatives_of("press");
  const double arm = b - mu * r;

  // The plunger pushes down: press is -P.
  EXPECT_NEAR(slope(slopes, 0), -load * r * (a + b) / (arm * arm), 1e-11);
  EXPECT_NEAR(slope(slopes, 1), -load * mu * (a + b) / (arm * arm), 1e-11);
  EXPECT_NEAR(slope(slopes, 2), -load / arm, 1e-12);
  EXPECT_NEAR(slope(slopes, 3), load * (a + mu * r) / (arm * arm), 1e-11);
  EXPECT_NEAR(slope(slopes, 4), -(a + mu * r) / arm, 1e-13);
}

// Pulled at the offset e against F in the middle: P = F + 2 μ P e/L.
std::string drawer(double offset, double mu) {
  return fmt::format(
      "kinestat: 1\n"
      "space: planar\n"
      "parameters: {{mu: {}, e: {}, L: 0.6, F: 30}}\n"
      "ground: f\n"
      "bodies: [drawer, hand]\n"
      "couplings:\n"
      "  d: {{type: prismatic, bodies: [f, drawer], at: [0, 0], axis: x, friction: {{mu: mu, "
      "length: L}}}}\n"
      "  c: {{type: point_contact, bodies: [hand, drawer], at: [1, e], normal: x}}\n"
      "  g: {{type: prismatic, bodies: [f, hand], at: [1, e], axis: x}}\n"
      "actuators: {{pull: {{coupling: g}}}}\n"
      "loads: {{w: {{body: drawer, at: [0, 0], force: [-F, 0]}}}}\n"
      "cases: {{k: {{motion: {{pull: 0.1}}}}}}\n",
      mu,
      offset);
}

TEST(Drawer, HasTheDerivativesOfItsClosedForm) {
  const double mu = 0.2;
  const double e = 0.5;
  const double length = 0.6;
  const double share = 1.0 - 2.0 * mu * e / length;
  const Solved solved(drawer(e, mu));
  const Slopes pull = solved.derivatives_of("pull");
  const Slopes drag = solved.derivatives_of("statics/friction/d/drag");  // P - F

  EXPECT_NEAR(slope(pull, 0), 30.0 * 2.0 * e / length / (share * share), 1e-11);
  EXPECT_NEAR(slope(pull, 1), 30.0 * 2.0 * mu / length / (share * share), 1e-11);
  EXPECT_NEAR(slope(pull, 2), -30.0 * 2.0 * mu * e / (length * length) / (share * share), 1e-11);
  EXPECT_NEAR(slope(pull, 3), 1.0 / share, 1e-13);
  EXPECT_NEAR(slope(drag, 3), 1.0 / share - 1.0, 1e-13);
}

// P = F + 2 μ P |e|/L has a corner at e = 0, towards which no other parameter moves.
TEST(Drawer, HasNoDerivativeWhereItsGuideBeginsToPress) {
  const Slopes slopes = Solved(drawer(0.0, 0.2)).derivatives_of("pull");

  EXPECT_EQ(slope(slopes, 0), 0.0);
  EXPECT_FALSE(slopes[1].has_value());
  EXPECT_EQ(slope(slopes, 2), 0.0);
  EXPECT_NEAR(slope(slopes, 3), 1.0, 1e-14);
}

// Beside the corner, however near, the guide presses on one side: 2 μ F/L.
TEST(Drawer, HasADerivativeWhereItsGuidePressesALittle) {
  for (const double sign : {1.0, -1.0}) {
    const Slopes slopes = Solved(drawer(sign * 1e-13, 0.2)).derivatives_of("pull");

    EXPECT_NEAR(slope(slopes, 1), sign * 30.0 * 2.0 * 0.2 / 0.6, 1e-10);
  }
}

// A coefficient of friction of zero cannot become smaller.
TEST(Drawer, HasNoDerivativeWhereFrictionBegins) {
  const Solved solved(drawer(0.5, 0.0));
  const Slopes slopes = solved.derivatives_of("pull");

  EXPECT_FALSE(slopes[0].has_value());
  EXPECT_NEAR(slope(slopes, 3), 1.0, 1e-14);
  EXPECT_EQ(slope(solved.derivatives_of("d.vx"), 0), 0.0);
}

// T = τ + c ω + μ r R, and the power that the journal takes is T ω.
TEST(Journal, DependsOnItsSpeedThroughTheOil) {
  for (const double sign : {1.0, -1.0}) {
    const Solved solved(
        fmt::format("kinestat: 1\n"
                    "space: planar\n"
                    "parameters: {{c: 0.05, speed: {}, tau: 0.2}}\n"
                    "ground: f\n"
                    "bodies: [shaft]\n"
                    "couplings:\n"
                    "  a: {{type: revolute, bodies: [f, shaft], at: [0, 0],\n"
                    "      friction: {{mu: 0.1, radius: 0.03, tau: tau, c: c}}}}\n"
                    "actuators: {{drive: {{coupling: a}}}}\n"
                    "loads: {{w: {{body: shaft, at: [0, 0], force: [60, -80]}}}}\n"
                    "cases: {{k: {{motion: {{drive: speed}}}}}}\n",
                    2.0 * sign));
    const Slopes torque = solved.derivatives_of("drive");
    const Slopes lost = solved.derivatives_of("power/friction/a");

    EXPECT_NEAR(slope(torque, 0), 2.0 * sign, 1e-14);
    EXPECT_NEAR(slope(torque, 1), 0.05, 1e-15);
    EXPECT_NEAR(slope(torque, 2), sign, 1e-15);
    EXPECT_NEAR(slope(lost, 0), -4.0, 1e-13);
    EXPECT_NEAR(slope(lost, 1), -sign * (0.2 + 2.0 * 0.05 * 2.0 + 0.3), 1e-13);
  }
}

// A block slips sideways on a belt that runs below it: its drag μ N lies along the slip
// (v, w), so its part across the belt is μ N w/√(v² + w²).
TEST(Contact, TurnsItsDragWithTheSlip) {
  const double mu = 0.25;
  const double load = 8.0;
  const double v = 3.0;
  const double w = 4.0;
  const Slopes slopes =
      Solved(
          "kinestat: 1\n"
          "parameters: {mu: 0.25, Fn: 8, v: 3, w: 4}\n"
          "ground: f\n"
          "bodies: [belt, cross, block]\n"
          "couplings:\n"
          "  b: {type: prismatic, bodies: [f, belt], at: [0, 0, 0], axis: x}\n"
          "  a: {type: prismatic, bodies: [f, cross], at: [0, 0, 1], axis: y}\n"
          "  l: {type: prismatic, bodies: [cross, block], at: [0, 0, 1], axis: z}\n"
          "  c: {type: point_contact, bodies: [belt, block], at: [0, 0, 0], normal: z, friction: "
          "mu}\n"
          "actuators: {run: {coupling: b}, shift: {coupling: a}}\n"
          "loads: {w: {body: block, at: [0, 0, 1], force: [0, 0, -Fn]}}\n"
          "cases: {k: {motion: {run: v, shift: w}}}\n")
          .derivatives_of("shift");
  const double slip = std::hypot(v, w);

  EXPECT_NEAR(slope(slopes, 0), load * w / slip, 1e-13);
  EXPECT_NEAR(slope(slopes, 1), mu * w / slip, 1e-14);
  EXPECT_NEAR(slope(slopes, 2), -mu * load * w * v / (slip * slip * slip), 1e-14);
  EXPECT_NEAR(slope(slopes, 3), mu * load * v * v / (slip * slip * slip), 1e-14);
}

}  // namespace
}  // namespace kinestat
