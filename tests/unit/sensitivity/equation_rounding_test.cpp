#include "studies/sensitivity/equation_rounding.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/rounding.hpp"
#include "network/bases.hpp"
#include "sensitivity/solved_case.hpp"
#include "support/mechanism_text.hpp"

namespace kinestat {
namespace {

double bound_of_rate(const Solved& solved, std::string_view freedom) {
  const std::vector<std::size_t> wanted = {
      static_cast<std::size_t>(freedom_index(solved.mechanism, freedom))};
  return rate_rounding(wanted, solved.mechanism, solved.mechanism.cases[0], solved.motion)[0];
}

double bound_of_action(const Solved& solved, std::string_view action) {
  const std::vector<std::size_t> wanted = {
      static_cast<std::size_t>(action_index(solved.mechanism, action))};
  return action_rounding(wanted, solved.mechanism, solved.mechanism.cases[0], solved.action)[0];
}

// On one axis, pitches p1 and p2: ω1 + ω2 = 0 and v = p1 ω1 + p2 ω2. Each coupling has its rates
// times the sizes of their screws as terms, its turn and its slide are off by kDataRounding of
// these together, and v is so of all slides, and by the second screw of all turns.
TEST(RateRounding, OfADifferentialScrewIsThatOfItsScrewsByThePitches) {
  const double p1 = 0.75;
  const double p2 = 0.5;
  const double w = 3.0;
  const Solved solved(fmt::format(
      "kinestat: 1\nspace: spatial\nground: frame\nbodies: [screw, slide]\ncouplings:\n"
      "  h1: {{type: helical, bodies: [frame, screw], at: [0, 0, 0], axis: x, pitch: {}}}\n"
      "  h2: {{type: helical, bodies: [screw, slide], at: [1, 0, 0], axis: x, pitch: {}}}\n"
      "  p: {{type: prismatic, bodies: [frame, slide], at: [1, 0, 0], axis: x}}\n"
      "cases: {{k: {{motion: {{h1.w: {} rad/s}}}}}}\n",
      p1,
      p2,
      w));
  const double unit =
      motion_basis(solved.mechanism.geometry, OrderChoice::minimal).length_unit(ScrewKind::twist);
  const double v = (p1 - p2) * w;

  const double turns = w * (1.0 + p1 / unit) + w * (1.0 + p2 / unit) + v / unit;

  const double tiny = 1e-14 * kDataRounding;
  EXPECT_NEAR(bound_of_rate(solved, "p.vx"), kDataRounding * turns * (unit + p2), tiny);
  EXPECT_NEAR(bound_of_rate(solved, "h2.w"), kDataRounding * turns, tiny);
  EXPECT_EQ(bound_of_rate(solved, "h1.w"), 0.0);
}

// A torque holds an arm: T = F d, and the pin bears F. Forces, the torque and the moment of the
// load are terms of the one body.
TEST(ActionRounding, OfAHeldArmIsThatOfAllThatActsOnIt) {
  const double force = 5.0;
  const double lever = 2.0;
  const Solved solved(fmt::format(
      "kinestat: 1\nspace: planar\nground: frame\nbodies: [arm]\ncouplings:\n"
      "  a: {{type: revolute, bodies: [frame, arm], at: [0, 0]}}\n"
      "actuators: {{hold: {{coupling: a}}}}\n"
      "cases: {{k: {{loads: {{weight: {{body: arm, at: [{}, 0], force: [0, -{}]}}}}}}}}\n",
      lever,
      force));
  const double unit = action_basis(solved.mechanism.geometry,
                                   OrderChoice::minimal,
                                   wrenches_of(solved.mechanism.cases[0].loads))
                          .length_unit(ScrewKind::wrench);

  const double terms = 2.0 * force + 2.0 * force * lever / unit;

  const double tiny = 1e-14 * kDataRounding;
  EXPECT_NEAR(bound_of_action(solved, "hold"), kDataRounding * terms * unit, tiny);
  EXPECT_NEAR(bound_of_action(solved, "a.Ry"), kDataRounding * terms, tiny);
}

// Two actuators on one slide: their actions are terms, and each is as far off as both are.
TEST(ActionRounding, OfAnActuatorAgainstAnotherIsThatOfBoth) {
  const Solved solved(
      "kinestat: 1\nspace: planar\nground: frame\nbodies: [block]\ncouplings:\n"
      "  p: {type: prismatic, bodies: [frame, block], at: [0, 0], axis: x}\n"
      "  q: {type: prismatic, bodies: [frame, block], at: [0, 0], axis: x}\n"
      "actuators: {push: {coupling: p}, hold: {coupling: q}}\n"
      "cases: {k: {action: {push: 3 N}}}\n");

  EXPECT_NEAR(bound_of_action(solved, "hold"), kDataRounding * 6.0, 1e-14 * kDataRounding);
  EXPECT_EQ(bound_of_action(solved, "push"), 0.0);
}

}  // namespace
}  // namespace kinestat
