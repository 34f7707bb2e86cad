#include <cmath>

#include <gtest/gtest.h>

#include "unit/motion/moving.hpp"

namespace kinestat {
namespace {

const std::string kFourBar =
    "space: planar\nground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
    "  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}\n"
    "  b: {type: revolute, bodies: [crank, coupler], at: [0, 1]}\n"
    "  c: {type: revolute, bodies: [coupler, rocker], at: [3, 2]}\n"
    "  d: {type: revolute, bodies: [frame, rocker], at: [3, 0]}\n";

// The same with the pin of the rocker drawn elsewhere on the rocker.
Moving drawn_apart(const Vec3& on_rocker) {
  Moving subject = moving(kFourBar, {"a.wz"});
  subject.drawn[2].at_head = on_rocker;
  subject.network =
      make_motion_network(subject.mechanism, subject.drawn, subject.network.driven_freedoms);
  return subject;
}

// Coupler √10 from (0, 1), rocker 2.1 from (3, 0): the pin comes to where both circles meet, and
// the crank, which is driven, stays.
TEST(Assembly, ClosesWhatIsDrawnApart) {
  const Moving subject = drawn_apart({3.0, 2.1, 0.0});

  const MotionSolution solution = move(subject, 0.0, 0.1, 2);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  ASSERT_EQ(solution.assembly.drawn_misses.size(), 1U);
  EXPECT_EQ(solution.assembly.drawn_misses[0].coupling, subject.coupling("c"));
  EXPECT_NEAR(solution.assembly.drawn_misses[0].distance, 0.1, 1e-12);
  const auto& poses = solution.assembly.corrections;
  ASSERT_EQ(poses.size(), 4U);
  EXPECT_LE(poses[1].shift.norm(), 1e-15);
  const Vec3 pin = poses[2].point({3.0, 2.0, 0.0});
  EXPECT_LE((pin - poses[3].point({3.0, 2.1, 0.0})).norm(), 1e-12);
  EXPECT_NEAR((pin - Vec3(0.0, 1.0, 0.0)).norm(), std::sqrt(10.0), 1e-12);
  EXPECT_NEAR((pin - Vec3(3.0, 0.0, 0.0)).norm(), 2.1, 1e-12);
}

// The rocker is 9 long: crank 1 + coupler √10 + ground 3 do not reach it. The closest is all links
// in line.
TEST(Assembly, OfLinksThatAreTooShortMissesByTheRest) {
  const Moving subject = drawn_apart({3.0, 9.0, 0.0});

  const MotionSolution solution = move(subject, 0.0, 0.1, 2);

  ASSERT_EQ(solution.status, MotionStatus::not_assembled);
  EXPECT_FALSE(solution.assembly.closes);
  EXPECT_FALSE(solution.assembly.closes_elsewhere);
  ASSERT_EQ(solution.assembly.nearest_misses.size(), 1U);
  EXPECT_NEAR(solution.assembly.nearest_misses[0].distance, 9.0 - 4.0 - std::sqrt(10.0), 1e-9);
}

// A rocker of 5.8 is reached by the crank in another position only.
TEST(Assembly, SaysWhenTheDriveWouldHaveToMove) {
  const Moving subject = drawn_apart({3.0, 6.5, 0.0});

  const MotionSolution solution = move(subject, 0.0, 0.1, 2);

  ASSERT_EQ(solution.status, MotionStatus::not_assembled);
  EXPECT_TRUE(solution.assembly.closes_elsewhere);
}

// Two freedoms and one drive.
TEST(Motion, NamesAFreedomThatTheDriveLeavesOpen) {
  const Moving subject = moving(
      "space: planar\nground: frame\nbodies: [one, two, three, four]\ncouplings:\n"
      "  a: {type: revolute, bodies: [frame, one], at: [0, 0]}\n"
      "  b: {type: revolute, bodies: [one, two], at: [0, 2]}\n"
      "  c: {type: revolute, bodies: [two, three], at: [2, 3]}\n"
      "  d: {type: revolute, bodies: [three, four], at: [4, 2]}\n"
      "  e: {type: revolute, bodies: [frame, four], at: [4, 0]}\n",
      {"a.wz"});

  const MotionSolution solution = move(subject, 0.0, 1.0, 10);

  EXPECT_EQ(solution.status, MotionStatus::undetermined);
  EXPECT_EQ(solution.open_freedoms.size(), 1U);
}

// A triangle of three links does not move.
TEST(Motion, SaysThatADriveIsLocked) {
  const Moving subject = moving(
      "space: planar\nground: frame\nbodies: [one, two]\ncouplings:\n"
      "  a: {type: revolute, bodies: [frame, one], at: [0, 0]}\n"
      "  b: {type: revolute, bodies: [one, two], at: [1, 2]}\n"
      "  c: {type: revolute, bodies: [frame, two], at: [3, 0]}\n",
      {"a.wz"});

  EXPECT_EQ(move(subject, 0.0, 1.0, 10).status, MotionStatus::drives_locked);
}

// Drawn with all links in line, nothing tells which way the rocker turns.
TEST(Motion, DoesNotChooseABranchOfAChangePoint) {
  const Moving subject = moving(
      "space: planar\nground: frame\nbodies: [crank, coupler, rocker]\ncouplings:\n"
      "  a: {type: revolute, bodies: [frame, crank], at: [0, 0]}\n"
      "  b: {type: revolute, bodies: [crank, coupler], at: [1, 0]}\n"
      "  c: {type: revolute, bodies: [coupler, rocker], at: [4, 0]}\n"
      "  d: {type: revolute, bodies: [frame, rocker], at: [3, 0]}\n",
      {"a.wz"});

  EXPECT_EQ(move(subject, 0.0, 1.0, 10).status, MotionStatus::singular);
}

// Where one drive holds still, the five-bar is a four-bar.
TEST(Motion, LetsADriveHoldStill) {
  const std::string five_bar =
      "space: planar\nground: frame\nbodies: [one, two, three, four]\ncouplings:\n"
      "  a: {type: revolute, bodies: [frame, one], at: [0, 0]}\n"
      "  b: {type: revolute, bodies: [one, two], at: [0, 2]}\n"
      "  c: {type: revolute, bodies: [two, three], at: [2, 3]}\n"
      "  d: {type: revolute, bodies: [three, four], at: [4, 2]}\n"
      "  e: {type: revolute, bodies: [frame, four], at: [4, 0]}\n";
  const Moving subject = moving(five_bar, {"a.wz", "e.wz"});
  const auto& drives = subject.network.driven_freedoms;

  const MotionSolution solution = solve_motion(
      subject.network,
      {.drives = {{.freedom = drives[0], .to = -0.4}, {.freedom = drives[1]}}, .steps = 8});

  ASSERT_EQ(solution.status, MotionStatus::completed);
  const Vec3 one = point_at(subject, solution, 8, subject.body("one"), {0.0, 2.0, 0.0});
  const Vec3 pin = point_at(subject, solution, 8, subject.body("two"), {2.0, 3.0, 0.0});
  EXPECT_NEAR((pin - one).norm(), std::sqrt(5.0), 1e-12);
  EXPECT_NEAR((pin - Vec3(4.0, 2.0, 0.0)).norm(), std::sqrt(5.0), 1e-12);
}

// The drive begins at 0.5 and ends at -0.3, both from the drawn position.
TEST(Motion, RunsFromWhereTheDriveBegins) {
  const Moving subject = moving(kFourBar, {"a.wz"});

  const MotionSolution solution = move(subject, 0.5, -0.3, 8);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_NEAR(subject.position(solution.configuration_at(0), "a.wz"), 0.5, 1e-15);
  EXPECT_NEAR(subject.position(solution.configuration_at(8), "a.wz"), -0.3, 1e-15);
}

}  // namespace
}  // namespace kinestat
