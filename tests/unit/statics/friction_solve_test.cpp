#include "statics/friction_solve.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "kinematics/velocity.hpp"
#include "network/bases.hpp"
#include "statics/action.hpp"
#include "support/mechanism_text.hpp"

namespace kinestat {
namespace {

// The first case of a mechanism with friction.
struct SolvedWithFriction {
  Mechanism mechanism;
  StaticSolution solution;

  explicit SolvedWithFriction(const std::string& text) : mechanism(mechanism_of(text)) {
    const Case& which = mechanism.cases.front();
    const KinematicSolution motion = solve_velocity(
        mechanism, motion_basis(mechanism.geometry, OrderChoice::minimal), which.motions);
    EXPECT_EQ(motion.status, SolveStatus::solved);
    std::vector<FrictionLaw> laws;
    for (const auto& law : find_friction_laws(mechanism, which, motion)) {
      EXPECT_TRUE(law.has_value());
      laws.push_back(law.value_or(FrictionLaw{}));
    }
    const std::vector<BodyWrench> loads = wrenches_of(which.loads);
    solution = solve_with_friction(mechanism,
                                   action_basis(mechanism.geometry, OrderChoice::minimal, loads),
                                   which.actions,
                                   loads,
                                   laws);
  }

  double action(const std::string& name) const {
    const auto a = static_cast<std::size_t>(action_index(mechanism, name));
    return solution.magnitudes.empty() ? NAN : solution.magnitudes[a].value_or(NAN);
  }
};

// A nut, which does not turn, on a screw that does; the load 1 N pushes the nut down.
std::string jack(double mu, double pitch, double speed) {
  return fmt::format(
      "ground: base\n"
      "bodies: [screw, nut]\n"
      "couplings:\n"
      "  b: {{type: revolute, bodies: [base, screw], at: [0, 0, 0], axis: z}}\n"
      "  t: {{type: helical, bodies: [screw, nut], at: [0, 0, 1], axis: z, pitch: {},\n"
      "      friction: {{mu: {}, radius: 0.02}}}}\n"
      "  g: {{type: prismatic, bodies: [base, nut], at: [1, 0, 1], axis: z}}\n"
      "actuators: {{crank: {{coupling: b}}, lift: {{coupling: g}}}}\n"
      "cases: {{k: {{motion: {{lift: {}}}, action: {{lift: -1}}}}}}\n",
      pitch,
      mu,
      speed);
}

// T = W r tan(φ + λ) to raise, W r tan(φ - λ) to lower: Shigley's Mechanical Engineering Design,
// section 8-2 (power screws), square thread, in the friction angle φ = atan μ.
TEST(ScrewJack, NeedsTheTorquesOfTheTextbook) {
  constexpr double kRadius = 0.02;
  for (const double mu : {0.0, 0.05, 0.15, 0.6}) {
    for (const double pitch : {0.0005, 0.003, 0.015}) {
      const double lead = std::atan(pitch / kRadius);
      const double angle = std::atan(mu);
      const double raise = kRadius * std::tan(angle + lead);
      const double lower = kRadius * std::tan(angle - lead);
      for (const double hand : {1.0, -1.0}) {
        // A positive turn of the screw in the base moves a nut on a right-handed thread down.
        if (mu > 0.0) {
          EXPECT_NEAR(SolvedWithFriction(jack(mu, hand * pitch, 1.0)).action("crank"),
                      -hand * raise,
                      1e-15);
          EXPECT_NEAR(SolvedWithFriction(jack(mu, hand * pitch, -1.0)).action("crank"),
                      hand * lower,
                      1e-15);
        }
      }
    }
  }
}

TEST(ScrewJack, LowersItselfUpToTheAngleOfSelfLocking) {
  constexpr double kRadius = 0.02;
  const double limit = 0.1;  // tan λ: friction of that coefficient just holds
  const auto torque = [&](double mu) {
    return SolvedWithFriction(jack(mu, kRadius * limit, -1.0)).action("crank");
  };

  EXPECT_LT(torque(limit - 1e-6), 0.0);  // the crank brakes
  EXPECT_NEAR(torque(limit), 0.0, 1e-16);
  EXPECT_GT(torque(limit + 1e-6), 0.0);  // the crank must drive
}

// The crank is known and the load is wanted: W = T / (r tan(λ + φ)).
TEST(ScrewJack, RaisesWhatAKnownTorqueCan) {
  std::string text = jack(0.15, 0.003, 1.0);
  text.replace(text.find("action: {lift: -1}"), 18, "action: {crank: -2}");

  EXPECT_NEAR(SolvedWithFriction(text).action("lift"),
              -2.0 / (0.02 * std::tan(std::atan(0.15) + std::atan(0.15))),
              1e-10);
}

// Braked by the crank while the load pushes up: beyond the self-locking angle there is no load
// that could do so.
TEST(ScrewJack, LocksWhereTheLoadWouldHaveToDriveIt) {
  std::string text = jack(0.3, 0.003, 1.0);
  text.replace(text.find("action: {lift: -1}"), 18, "action: {crank: 2}");
  const SolvedWithFriction solved(text);

  EXPECT_EQ(solved.solution.status, SolveStatus::locked_by_friction);
  EXPECT_TRUE(solved.solution.magnitudes.empty());
}

// A shaft in one bearing, which bears 100 N across: the drive overcomes μ r R + tau + c ω.
TEST(JournalFriction, IsACoupleAgainstTheMotion) {
  for (const double speed : {2.0, -2.0}) {
    const SolvedWithFriction solved(fmt::format(
        "space: planar\n"
        "ground: f\n"
        "bodies: [shaft]\n"
        "couplings:\n"
        "  a: {{type: revolute, bodies: [f, shaft], at: [0, 0], friction: {{mu: 0.1, radius: "
        "0.03, tau: 0.2, c: 0.05}}}}\n"
        "actuators: {{drive: {{coupling: a}}}}\n"
        "loads: {{w: {{body: shaft, at: [0, 0], force: [60, -80]}}}}\n"
        "cases: {{k: {{motion: {{drive: {}}}}}}}\n",
        speed));

    const double couple = 0.1 * 0.03 * 100.0 + 0.2 + 0.05 * 2.0;
    EXPECT_NEAR(solved.action("drive"), speed > 0.0 ? couple : -couple, 1e-13);
    ASSERT_EQ(solved.solution.friction.size(), 1U);
    EXPECT_NEAR(solved.solution.friction[0].magnitude, couple, 1e-13);
    EXPECT_NEAR(solved.solution.wrenches[0]->moment.z(), 0.0, 1e-13);  // drive and friction
  }
}

// A shaft along z whose bearing at z = 0.5 takes the forces and the couple of a load there.
std::string shaft(const std::string& friction, const std::string& load) {
  return fmt::format(
      "ground: f\n"
      "bodies: [shaft]\n"
      "couplings:\n"
      "  a: {{type: revolute, bodies: [f, shaft], at: [0, 0, 0.5], axis: z, friction: {}}}\n"
      "actuators: {{drive: {{coupling: a}}}}\n"
      "loads: {{w: {{body: shaft, at: [0, 0, 0.5], {}}}}}\n"
      "cases: {{k: {{motion: {{drive: 1}}}}}}\n",
      friction,
      load);
}

TEST(JournalFriction, IsThatOfTheCollarToo) {
  const std::string friction = "{mu: 0.1, radius: 0.03, thrust_radius: 0.05}";

  EXPECT_NEAR(SolvedWithFriction(shaft(friction, "force: [30, 40, -200]")).action("drive"),
              0.1 * (0.03 * 50.0 + 0.05 * 200.0),
              1e-14);
}

// Ends 0.2 apart bear the couple 7 with 35 N each, across a force of 50 N in the same plane: while
// 35 N exceed 25 N they press to opposite sides.
TEST(JournalFriction, IsThatOfTheEndsOfALongJournal) {
  const std::string friction = "{mu: 0.1, radius: 0.03, length: 0.2}";

  EXPECT_NEAR(
      SolvedWithFriction(shaft(friction, "force: [50, 0, 0], couple: [0, 7, 0]")).action("drive"),
      0.1 * 0.03 * 70.0,
      1e-14);
  EXPECT_NEAR(
      SolvedWithFriction(shaft(friction, "force: [50, 0, 0], couple: [0, 2, 0]")).action("drive"),
      0.1 * 0.03 * 50.0,
      1e-14);
}

TEST(JournalFriction, LeavesOutWhatHasNoDimensionAndSaysSo) {
  const SolvedWithFriction solved(
      shaft("{mu: 0.1, radius: 0.03}", "force: [3, 4, -200], couple: [0, 7, 0]"));

  EXPECT_NEAR(solved.action("drive"), 0.1 * 0.03 * 5.0, 1e-14);
  ASSERT_EQ(solved.solution.ignored.size(), 2U);
  EXPECT_EQ(solved.solution.ignored[0].reaction, Reaction::tilting);
  EXPECT_NEAR(solved.solution.ignored[0].size, 7.0, 1e-13);
  EXPECT_EQ(solved.solution.ignored[1].reaction, Reaction::axial);
  EXPECT_NEAR(solved.solution.ignored[1].size, 200.0, 1e-12);
}

// One bearing that is known and two that share what equilibrium leaves open.
TEST(JournalFriction, IsOpenWhereTheActionsAreThatPress) {
  const SolvedWithFriction solved(
      "space: planar\n"
      "ground: f\n"
      "bodies: [bar, wheel]\n"
      "couplings:\n"
      "  a: {type: revolute, bodies: [f, wheel], at: [0, 0], friction: {mu: 0.1, radius: 0.03}}\n"
      "  b: {type: revolute, bodies: [f, wheel], at: [0, 0], friction: {mu: 0.2, radius: 0.03}}\n"
      "  c: {type: revolute, bodies: [f, bar], at: [2, 0], friction: {mu: 0.3, radius: 0.03}}\n"
      "actuators: {turn: {coupling: a}, swing: {coupling: c}}\n"
      "loads:\n"
      "  w: {body: wheel, at: [0, 0], force: [0, -80]}\n"
      "  v: {body: bar, at: [2, 0], force: [0, -50]}\n"
      "cases: {k: {motion: {turn: 1, swing: 1}}}\n");

  EXPECT_EQ(solved.solution.status, SolveStatus::underdetermined);
  EXPECT_TRUE(std::isnan(solved.action("turn")));
  EXPECT_TRUE(std::isnan(solved.action("a.Ry")));
  EXPECT_NEAR(solved.action("swing"), 0.3 * 0.03 * 50.0, 1e-14);
  EXPECT_EQ(solved.solution.open_friction.size(), 2U);
  ASSERT_EQ(solved.solution.friction.size(), 1U);
  EXPECT_NEAR(solved.solution.friction[0].magnitude, 0.3 * 0.03 * 50.0, 1e-14);
}

// A spline that keeps a sleeve from turning at the radius 0.02.
TEST(GuideFriction, IsThatOfACoupleAboutItsAxisToo) {
  const SolvedWithFriction solved(
      "ground: f\n"
      "bodies: [sleeve]\n"
      "couplings:\n"
      "  a: {type: prismatic, bodies: [f, sleeve], at: [0, 0.3, 0], axis: x,\n"
      "      friction: {mu: 0.1, radius: 0.02}}\n"
      "actuators: {push: {coupling: a}}\n"
      "loads: {w: {body: sleeve, at: [0, 0.3, 0], force: [0, -5, 0], couple: [8, 0, 0]}}\n"
      "cases: {k: {motion: {push: 1}}}\n");

  EXPECT_NEAR(solved.action("push"), 0.1 * 5.0 + 0.1 * 8.0 / 0.02, 1e-12);
}

std::string guide(const std::string& friction, double height) {
  return fmt::format(
      "space: planar\n"
      "ground: f\n"
      "bodies: [block]\n"
      "couplings:\n"
      "  a: {{type: prismatic, bodies: [f, block], at: [0, 0], axis: x, friction: {}}}\n"
      "actuators: {{drive: {{coupling: a}}}}\n"
      "loads: {{w: {{body: block, at: [0, {}], force: [-10, -30]}}}}\n"
      "cases: {{k: {{motion: {{drive: 1}}}}}}\n",
      friction,
      height);
}

TEST(GuideFriction, IsThatOfTheForceAcross) {
  EXPECT_NEAR(SolvedWithFriction(guide("0.2", 0.0)).action("drive"), 10.0 + 0.2 * 30.0, 1e-13);
  EXPECT_NEAR(SolvedWithFriction(guide("{mu: 0.2, c: 3}", 0.0)).action("drive"), 19.0, 1e-13);
}

// Edges 0.4 apart: while the couple 10 h is below 30 · 0.2 both press down, 30 N together; beyond
// it they press against each other, |15 + 25 h| + |15 - 25 h|.
TEST(GuideFriction, IsThatOfTheEdgesOfALongGuide) {
  for (const double height : {0.0, 0.3, 0.59}) {
    EXPECT_NEAR(
        SolvedWithFriction(guide("{mu: 0.2, length: 0.4}", height)).action("drive"), 16.0, 1e-12);
  }
  for (const double height : {0.7, 2.0}) {
    EXPECT_NEAR(SolvedWithFriction(guide("{mu: 0.2, length: 0.4}", height)).action("drive"),
                10.0 + 0.2 * 50.0 * height,
                1e-12);
  }
}

// A drawer pushed at a distance h from the middle of its guide: P (1 - 2 μ h / length) = F.
std::string drawer(double mu) {
  return fmt::format(
      "space: planar\n"
      "ground: f\n"
      "bodies: [drawer, hand]\n"
      "couplings:\n"
      "  a: {{type: prismatic, bodies: [f, drawer], at: [0, 0], axis: x, friction: {{mu: {}, "
      "length: 0.4}}}}\n"
      "  h: {{type: prismatic, bodies: [f, hand], at: [-1, 0.5], axis: x}}\n"
      "  c: {{type: point_contact, bodies: [hand, drawer], at: [-1, 0.5], normal: x}}\n"
      "actuators: {{push: {{coupling: h}}}}\n"
      "loads: {{w: {{body: drawer, at: [0, 0], force: [-10, 0]}}}}\n"
      "cases: {{k: {{motion: {{push: 1}}}}}}\n",
      mu);
}

TEST(GuideFriction, JamsADrawerThatIsPushedTooFarFromItsMiddle) {
  for (const double mu : {0.1, 0.3, 0.39, 0.3999}) {
    EXPECT_NEAR(SolvedWithFriction(drawer(mu)).action("push") * (1.0 - 2.5 * mu), 10.0, 1e-8) << mu;
  }
  for (const double mu : {0.4, 0.41, 1.0}) {
    EXPECT_EQ(SolvedWithFriction(drawer(mu)).solution.status, SolveStatus::locked_by_friction)
        << mu;
  }
}

TEST(FrictionLaws, AreMissingWhereNothingMoves) {
  const Mechanism mechanism = mechanism_of(guide("0.2", 0.0));
  KinematicSolution rest;
  rest.bodies.resize(2);
  rest.couplings.resize(1);

  EXPECT_EQ(find_friction_laws(mechanism, Case{}, rest).front().has_value(), false);
}

// A parallelogram, whose coupler does not turn, and an arm on it that slides in two guides and so
// does not turn either; `off` lengthens the rocker [m].
std::string parallelogram(double degrees, double off) {
  const double angle = degrees * std::numbers::pi / 180.0;
  const double x = std::cos(angle);
  const double y = std::sin(angle);
  return fmt::format(
      "space: planar\n"
      "ground: frame\n"
      "bodies: [crank, coupler, rocker, arm, slide]\n"
      "couplings:\n"
      "  a: {{type: revolute, bodies: [frame, crank], at: [0.013, 0.007]}}\n"
      "  b: {{type: revolute, bodies: [crank, coupler], at: [{}, {}]}}\n"
      "  c: {{type: revolute, bodies: [coupler, rocker], at: [{}, {}]}}\n"
      "  d: {{type: revolute, bodies: [frame, rocker], at: [0.713, 0.107]}}\n"
      "  e: {{type: revolute, bodies: [coupler, arm], at: [0.5, 0.83],\n"
      "      friction: {{mu: 0.3, radius: 0.1}}}}\n"
      "  f: {{type: prismatic, bodies: [arm, slide], at: [0.6, 0.83], axis: [0.3, 0.7]}}\n"
      "  g: {{type: prismatic, bodies: [slide, frame], at: [0.6, 0.93], axis: [1, 0.1]}}\n"
      "actuators: {{m: {{coupling: a}}, q: {{coupling: f}}}}\n"
      "cases: {{one: {{motion: {{m: 1}}, action: {{q: 100}}}}}}\n",
      0.013 + x,
      0.007 + y,
      0.713 + x,
      0.107 + y + off);
}

std::optional<FrictionLaw> law_in_parallelogram(double degrees, double off) {
  const Mechanism mechanism = mechanism_of(parallelogram(degrees, off));
  const KinematicSolution motion =
      solve_velocity(mechanism,
                     motion_basis(mechanism.geometry, OrderChoice::minimal),
                     mechanism.cases.front().motions);
  return find_friction_laws(mechanism, mechanism.cases.front(), motion).front();
}

// What is left of a rate that is zero has the sense of the roundings of its equations.
TEST(FrictionLaws, AreMissingWhereOnlyRoundingMoves) {
  for (int i = 0; i <= 30; ++i) {
    EXPECT_FALSE(law_in_parallelogram(8.0 + 0.01 * i, 0.0)) << i;
  }
}

TEST(FrictionLaws, ExistHoweverSlowTheMotion) {
  EXPECT_TRUE(law_in_parallelogram(8.0, 1e-9));
  EXPECT_TRUE(law_in_parallelogram(37.0, -1e-9));
}

TEST(FrictionLaws, OfNothingThatRubsAreNone) {
  EXPECT_TRUE(mechanism_of(guide("0", 0.0)).frictions.empty());
}

}  // namespace
}  // namespace kinestat
