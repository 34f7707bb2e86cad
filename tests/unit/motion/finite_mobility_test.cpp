#include "studies/motion/finite_mobility.hpp"

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

}  // namespace
}  // namespace kinestat
