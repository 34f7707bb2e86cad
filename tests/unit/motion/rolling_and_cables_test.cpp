#include <cmath>

#include <gtest/gtest.h>

#include "couplings/cable_geometry.hpp"
#include "support/angles.hpp"
#include "unit/motion/moving.hpp"

namespace kinestat {
namespace {

// Willis: 24 S + 60 R = 84 C, exactly over many turns; the planet turns 24/18 against the sun seen
// from the carrier.
TEST(Planetary, RollsByWillis) {
  const Moving subject = moving_file("gears/simple_planetary.yaml", {"S.wz", "R.wz"});
  const auto& drives = subject.network.driven_freedoms;

  const MotionSolution solution = solve_motion(
      subject.network,
      {.drives = {{.freedom = drives[0], .to = 40.0 * kPi}, {.freedom = drives[1], .to = -9.0}},
       .steps = 200});

  ASSERT_EQ(solution.status, MotionStatus::completed);
  for (int k = 0; k <= 200; ++k) {
    const double sun = solution.drive_value(0, k);
    const double carrier = (24.0 * sun + 60.0 * solution.drive_value(1, k)) / 84.0;
    const Configuration configuration = solution.configuration_at(k);
    EXPECT_NEAR(subject.position(configuration, "C.wz"), carrier, 1e-11);
    EXPECT_NEAR(subject.position(configuration, "P.wz"), -24.0 / 18.0 * (sun - carrier), 1e-11);
  }
}

// Willis: both half axles together turn twice as far as the case.
TEST(BevelDifferential, TurnsTwiceItsCase) {
  const Moving subject = moving_file("transmissions/bevel_differential.yaml", {"C.wx", "L.wx"});
  const auto& drives = subject.network.driven_freedoms;

  const MotionSolution solution = solve_motion(
      subject.network,
      {.drives = {{.freedom = drives[0], .to = 5.0}, {.freedom = drives[1], .to = 8.0}},
       .steps = 50});

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_NEAR(subject.position(solution.configuration_at(50), "R.wx"), 2.0, 1e-12);
  EXPECT_NEAR(subject.position(solution.configuration_at(50), "P.wz"), 3.0 * 1.6, 1e-12);
}

// v = w r with r = 30 mm, over three turns.
TEST(Rack, IsPushedByThePitchCircle) {
  const Moving subject = moving_file("planar/rack_and_pinion.yaml", {"a.wz"});

  const MotionSolution solution = move(subject, 0.0, 6.0 * kPi, 30);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_NEAR(subject.position(solution.configuration_at(30), "r.vx"), 0.18 * kPi, 1e-13);
}

// Upright falls: four of them, and half the difference of two drums (R - r)/2 by R.
TEST(Hoist, TakesUpTheRope) {
  const Moving tackle = moving_file("cables/block_and_tackle.yaml", {"H.vy"});
  const Moving weston = moving_file("cables/weston_hoist.yaml", {"H.vy"});

  const MotionSolution four = move(tackle, 0.0, -0.2, 50);
  const MotionSolution chain = move(weston, 0.0, -1.0, 50);

  ASSERT_EQ(four.status, MotionStatus::completed);
  ASSERT_EQ(chain.status, MotionStatus::completed);
  EXPECT_LE(worst_closure_error(four), 1e-12);
  EXPECT_NEAR(tackle.position(four.configuration_at(50), "L.vy"), 0.05, 1e-13);
  EXPECT_NEAR(tackle.position(four.configuration_at(50), "B1.wz"), 0.2 / 0.05, 1e-11);
  EXPECT_NEAR(weston.position(chain.configuration_at(50), "L.vy"), 0.05, 1e-12);
}

// A lever pulls a weight over a fixed drum: what leaves the tangent and the arc on one side is what
// the weight rises by.
TEST(Rope, KeepsItsLengthOverADrum) {
  const Moving subject = moving(
      "space: planar\nground: frame\nbodies: [lever, weight, drum]\ncouplings:\n"
      "  a: {type: revolute, bodies: [frame, lever], at: [0, 0]}\n"
      "  d: {type: revolute, bodies: [frame, drum], at: [4, 3]}\n"
      "  w: {type: prismatic, bodies: [frame, weight], at: [4.5, -2], axis: y}\n"
      "cables:\n  rope:\n    over:\n"
      "      - {body: lever, at: [1, 0]}\n"
      "      - {pulley: drum, radius: 0.5, wrap: clockwise}\n"
      "      - {body: weight, at: [4.5, -2]}\n",
      {"a.wz"});
  const CableStationGeometry drum{
      .centre = {4.0, 3.0, 0.0}, .radius = -0.5, .meets = {}, .leaves = {}};
  const CableStationGeometry below{.centre = {4.5, -2.0, 0.0}, .meets = {}, .leaves = {}};
  const auto length = [&](double angle) {
    const CableStationGeometry end{
        .centre = {std::cos(angle), std::sin(angle), 0.0}, .meets = {}, .leaves = {}};
    const CableSpan span = tangent_span<double>(end, drum);
    const CableSpan down = tangent_span<double>(drum, below);
    return (span.to - span.from).norm() + 0.5 * wrap_angle<double>(drum, span, down);
  };

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 120);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_LE(worst_closure_error(solution), 1e-12);
  for (int k = 0; k <= 120; ++k) {
    EXPECT_NEAR(subject.position(solution.configuration_at(k), "w.vy"),
                length(solution.drive_value(0, k)) - length(0.0),
                1e-12)
        << k;
  }
}

// r1 w1 = r2 w2 for the open belt, against each other for the crossed one.
TEST(Belt, TurnsBothPulleysByTheirRadii) {
  const Moving open = moving_file("cables/open_belt.yaml", {"A.wz"});
  const Moving crossed = moving_file("cables/crossed_belt.yaml", {"A.wz"});

  const MotionSolution first = move(open, 0.0, 30.0, 60);
  const MotionSolution second = move(crossed, 0.0, 30.0, 60);

  ASSERT_EQ(first.status, MotionStatus::completed);
  ASSERT_EQ(second.status, MotionStatus::completed);
  EXPECT_NEAR(open.position(first.configuration_at(60), "B.wz"), 30.0 * 40.0 / 90.0, 1e-11);
  EXPECT_LT(crossed.position(second.configuration_at(60), "B.wz"), 0.0);
}

// Contacts without profiles, and the gear of an unknown carrier, are named instead of moved.
TEST(Motion, NamesWhatItCannotMove) {
  const Moving clamp = moving_file("spatial/kelvin_clamp.yaml", {});

  ASSERT_FALSE(clamp.network.is_movable());
  EXPECT_EQ(clamp.network.obstacles.front().why, MotionObstacle::unknown_profile);
  EXPECT_EQ(clamp.network.obstacles.front().coupling, clamp.coupling("flat"));
}

}  // namespace
}  // namespace kinestat
