#include "studies/motion/finite_mobility.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "network/bases.hpp"
#include "unit/motion/moving.hpp"

namespace kinestat {
namespace {

FiniteMobility tried(const Moving& subject) {
  const MotionSpace space = find_motion_space(
      subject.mechanism, motion_basis(subject.mechanism.geometry, OrderChoice::minimal));
  return find_finite_mobility(subject.network, subject.mechanism, space.motions);
}

TEST(FiniteMobility, OfAFourBarIsItsFreedom) {
  const FiniteMobility mobility = tried(moving_file("planar/four_bar.yaml", {}));

  ASSERT_EQ(mobility.trials.size(), 1U);
  EXPECT_EQ(mobility.trials[0].persistence, Persistence::finite);
  EXPECT_EQ(mobility.nearby_freedom, 1);
  EXPECT_FALSE(mobility.is_singular());
}

// Overconstrained and mobile all the same.
TEST(FiniteMobility, OfBennettAndSarrusIsOne) {
  for (const char* file : {"spatial/bennett.yaml", "spatial/sarrus.yaml"}) {
    const FiniteMobility mobility = tried(moving_file(file, {}));

    ASSERT_EQ(mobility.trials.size(), 1U) << file;
    EXPECT_EQ(mobility.trials[0].persistence, Persistence::finite) << file;
    EXPECT_FALSE(mobility.is_singular()) << file;
  }
}

// Two links in line between two hinges shake across it, and go nowhere.
TEST(FiniteMobility, OfLinksInLineIsInstantaneous) {
  const FiniteMobility mobility =
      tried(moving("space: planar\nground: frame\nbodies: [one, two]\ncouplings:\n"
                   "  a: {type: revolute, bodies: [frame, one], at: [0, 0]}\n"
                   "  b: {type: revolute, bodies: [one, two], at: [1, 0]}\n"
                   "  c: {type: revolute, bodies: [frame, two], at: [3, 0]}\n",
                   {}));

  ASSERT_EQ(mobility.trials.size(), 1U);
  EXPECT_EQ(mobility.trials[0].persistence, Persistence::instantaneous);
  EXPECT_EQ(mobility.nearby_freedom, 0);
  EXPECT_TRUE(mobility.is_singular());
}

// A platform on three parallel cranks moves if they are equal; unequal ones only let it shake.
std::string three_cranks(const std::string& third) {
  return "space: planar\nground: frame\nbodies: [one, two, three, platform]\ncouplings:\n"
         "  a: {type: revolute, bodies: [frame, one], at: [0, 0]}\n"
         "  b: {type: revolute, bodies: [frame, two], at: [2, 0]}\n"
         "  c: {type: revolute, bodies: [frame, three], at: [5, " +
         third +
         "]}\n"
         "  d: {type: revolute, bodies: [one, platform], at: [0, 1]}\n"
         "  e: {type: revolute, bodies: [two, platform], at: [2, 1]}\n"
         "  f: {type: revolute, bodies: [three, platform], at: [5, 1]}\n";
}

TEST(FiniteMobility, OfEqualParallelCranksLasts) {
  const FiniteMobility mobility = tried(moving(three_cranks("0"), {}));

  ASSERT_EQ(mobility.trials.size(), 1U);
  EXPECT_EQ(mobility.trials[0].persistence, Persistence::finite);
}

TEST(FiniteMobility, OfUnequalParallelCranksDoesNot) {
  const FiniteMobility mobility = tried(moving(three_cranks("-1"), {}));

  ASSERT_EQ(mobility.trials.size(), 1U);
  EXPECT_EQ(mobility.trials[0].persistence, Persistence::instantaneous);
}

// Cranks of 1, 2 and 4, whose ends keep their second derivatives too, but miss with the fourth
// power of the way.
TEST(FiniteMobility, OfCranksThatMissLateIsInstantaneous) {
  const FiniteMobility mobility =
      tried(moving("space: planar\nground: frame\nbodies: [one, two, three, platform]\ncouplings:\n"
                   "  a: {type: revolute, bodies: [frame, one], at: [0, 0]}\n"
                   "  b: {type: revolute, bodies: [frame, two], at: [2, 0]}\n"
                   "  c: {type: revolute, bodies: [frame, three], at: [3, 0]}\n"
                   "  d: {type: revolute, bodies: [one, platform], at: [0, 1]}\n"
                   "  e: {type: revolute, bodies: [two, platform], at: [2, 2]}\n"
                   "  f: {type: revolute, bodies: [three, platform], at: [3, 4]}\n",
                   {}));

  ASSERT_EQ(mobility.trials.size(), 1U);
  EXPECT_EQ(mobility.trials[0].persistence, Persistence::instantaneous);
  EXPECT_EQ(mobility.nearby_freedom, 0);
}

// All links of a parallelogram in line: two freedoms, one as soon as it has moved.
TEST(FiniteMobility, OfAParallelogramInLineIsSingular) {
  const FiniteMobility mobility =
      tried(moving("space: planar\nground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
                   "  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}\n"
                   "  b: {type: revolute, bodies: [crank, coupler], at: [1, 0]}\n"
                   "  c: {type: revolute, bodies: [coupler, rocker], at: [4, 0]}\n"
                   "  d: {type: revolute, bodies: [frame, rocker], at: [3, 0]}\n",
                   {}));

  EXPECT_EQ(mobility.drawn_freedom, 2);
  EXPECT_EQ(mobility.nearby_freedom, 1);
  EXPECT_TRUE(mobility.is_singular());
}

// Bricard 1927: of six revolutes that are symmetric about a line, three close when the others do,
// which leaves one freedom. The line is z, and the decimals are exactly symmetric.
TEST(FiniteMobility, OfALineSymmetricBricardLinkageIsFinite) {
  const FiniteMobility mobility =
      tried(moving("ground: g\nbodies: [b1, b2, b3, b4, b5]\ncouplings:\n"
                   "  j0: {type: revolute, bodies: [b5, g], at: [0.189, -0.523, -0.413], "
                   "axis: [-2.441, 1.800, 1.144]}\n"
                   "  j1: {type: revolute, bodies: [g, b1], at: [-0.325, 0.774, 0.281], "
                   "axis: [-0.554, 0.978, -0.311]}\n"
                   "  j2: {type: revolute, bodies: [b1, b2], at: [-0.329, -0.792, 0.455], "
                   "axis: [-0.099, 0.545, -0.607]}\n"
                   "  j3: {type: revolute, bodies: [b2, b3], at: [-0.189, 0.523, -0.413], "
                   "axis: [2.441, -1.800, 1.144]}\n"
                   "  j4: {type: revolute, bodies: [b3, b4], at: [0.325, -0.774, 0.281], "
                   "axis: [0.554, -0.978, -0.311]}\n"
                   "  j5: {type: revolute, bodies: [b4, b5], at: [0.329, 0.792, 0.455], "
                   "axis: [0.099, -0.545, -0.607]}\n",
                   {}));

  ASSERT_EQ(mobility.trials.size(), 1U);
  EXPECT_EQ(mobility.trials[0].persistence, Persistence::finite);
  EXPECT_EQ(mobility.nearby_freedom, 1);
  EXPECT_FALSE(mobility.is_singular());
}

// Sliders of unit rods at right angles: each goes by half the square of the way of the one before,
// and the last rod ends on the frame. What is missed at the way s is 2 (s/2)^(2^rods).
std::string rods_at_right_angles(int rods) {
  std::string bodies;
  std::string couplings;
  int x = 0;
  int y = 0;
  for (int i = 0; i < rods; ++i) {
    const bool is_even = i % 2 == 0;
    const int next_x = x + (is_even ? 0 : 1);
    const int next_y = y + (is_even ? 1 : 0);
    const std::string head = i + 1 < rods ? fmt::format("s{}", i + 1) : "frame";
    bodies += fmt::format("{}s{}, r{}", i == 0 ? "" : ", ", i, i);
    couplings += fmt::format(
        "  g{0}: {{type: prismatic, bodies: [frame, s{0}], at: [{1}, {2}], axis: {3}}}\n"
        "  p{0}: {{type: revolute, bodies: [s{0}, r{0}], at: [{1}, {2}]}}\n"
        "  q{0}: {{type: revolute, bodies: [r{0}, {4}], at: [{5}, {6}]}}\n",
        i,
        x,
        y,
        is_even ? "x" : "y",
        head,
        next_x,
        next_y);
    x = next_x;
    y = next_y;
  }
  return fmt::format(
      "space: planar\nground: frame\nbodies: [{}]\ncouplings:\n{}", bodies, couplings);
}

TEST(FiniteMobility, OfRodsThatMissWithAHighPowerIsInstantaneous) {
  for (const int rods : {1, 2, 3, 4}) {
    const FiniteMobility mobility = tried(moving(rods_at_right_angles(rods), {}));

    ASSERT_EQ(mobility.trials.size(), 1U) << rods;
    EXPECT_EQ(mobility.trials[0].persistence, Persistence::instantaneous) << rods;
    EXPECT_EQ(mobility.nearby_freedom, 0) << rods;
  }
}

}  // namespace
}  // namespace kinestat
