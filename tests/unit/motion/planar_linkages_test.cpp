#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/angles.hpp"
#include "unit/motion/moving.hpp"

namespace kinestat {
namespace {

// Crank 1, rod 2.5, drawn at 60 deg; x = cos t + √(l² - sin² t), differentiated twice.
TEST(SliderCrank, HasTheStrokeOfTheClosedForm) {
  const double start = kPi / 3.0;
  const double l = 2.5;
  const double x0 = std::cos(start) + std::sqrt(l * l - std::pow(std::sin(start), 2));
  const Moving subject = moving(
      fmt::format("space: planar\nground: frame\nbodies: [crank, rod, slider]\ncouplings:\n"
                  "  a: {{type: revolute, bodies: [frame, crank], at: [0, 0]}}\n"
                  "  b: {{type: revolute, bodies: [crank, rod], at: [{}, {}]}}\n"
                  "  c: {{type: revolute, bodies: [rod, slider], at: [{}, 0]}}\n"
                  "  d: {{type: prismatic, bodies: [frame, slider], at: [{}, 0], axis: x}}\n",
                  std::cos(start),
                  std::sin(start),
                  x0,
                  x0),
      {"a.wz"});

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 360);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_LE(worst_closure_error(solution), 1e-12);
  const auto d = static_cast<std::size_t>(freedom_index(subject.mechanism, "d.vx"));
  for (int k = 0; k <= 360; ++k) {
    const double s = std::sin(start + k * kPi / 180.0);
    const double c = std::cos(start + k * kPi / 180.0);
    const double f = std::sqrt(l * l - s * s);
    const Configuration configuration = solution.configuration_at(k);
    EXPECT_NEAR(subject.position(configuration, "d.vx"), c + f - x0, 1e-12);
    // At 3 rad/s, rising by 2 rad/s².
    const MotionState state = state_at(subject, configuration, 3.0, 2.0);
    const double slope = -s - s * c / f;
    const double bend = -c - (c * c - s * s) / f - std::pow(s * c, 2) / std::pow(f, 3);
    EXPECT_NEAR(*state.rates[d], 3.0 * slope, 1e-11);
    EXPECT_NEAR(*state.rate_rates[d], 9.0 * bend + 2.0 * slope, 1e-10);
  }
}

// Driven by the slider, the linkage goes no further than where crank and rod are in line.
TEST(SliderCrank, StopsAtItsDeadPoint) {
  const Moving subject = moving(kSliderCrank, {"d.vx"});

  const MotionSolution solution = move(subject, 0.0, 20.0, 100);

  ASSERT_EQ(solution.status, MotionStatus::limit);
  EXPECT_NEAR(solution.drive_value(0, solution.position_count() - 1), 15.0 + 13.0 - 14.0, 1e-11);
}

// The pin of a dyad to the side of a → b on which it was drawn.
Vec3 dyad(const Vec3& a, const Vec3& b, double from_a, double from_b, double side) {
  const Vec3 between = b - a;
  const double length = between.norm();
  const double along = (length * length + from_a * from_a - from_b * from_b) / (2.0 * length);
  const double height = std::sqrt(from_a * from_a - along * along);
  const Vec3 u = between / length;
  return a + along * u + side * height * Vec3(-u.y(), u.x(), 0.0);
}

double side_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a).z() > 0.0 ? 1.0 : -1.0;
}

Vec3 turned(const Vec3& p, double angle) {
  return Eigen::AngleAxisd(angle, Vec3::UnitZ()) * p;
}

// The point of a body that was drawn at p, from two of its points.
Vec3 carried(const Vec3& p, const Vec3& a0, const Vec3& b0, const Vec3& a, const Vec3& b) {
  const double angle =
      std::atan2((b - a).y(), (b - a).x()) - std::atan2((b0 - a0).y(), (b0 - a0).x());
  return a + turned(p - a0, angle);
}

// Dyad by dyad: both circuits of the six-bars of the library, the last pin found.
TEST(SixBar, OfWattIsTwoDyads) {
  const Moving subject = moving_file("planar/watt_six_bar.yaml", {"a.wz"});
  const Vec3 b0(10.0, 40.0, 0.0), c0(70.0, 60.0, 0.0), d(80.0, 0.0, 0.0);
  const Vec3 e0(50.0, 90.0, 0.0), f0(120.0, 110.0, 0.0), g0(110.0, 50.0, 0.0);

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 720);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_LE(worst_closure_error(solution), 1e-12);
  for (int k = 0; k <= 720; ++k) {
    const Vec3 b = turned(b0, k * kPi / 360.0);
    const Vec3 c = dyad(b, d, (c0 - b0).norm(), (c0 - d).norm(), side_of(b0, d, c0));
    const Vec3 e = carried(e0, b0, c0, b, c);
    const Vec3 g = carried(g0, d, c0, d, c);
    const Vec3 f = dyad(e, g, (f0 - e0).norm(), (f0 - g0).norm(), side_of(e0, g0, f0));
    const Vec3 found = point_at(subject, solution, k, subject.body("swing"), 1e-3 * f0);
    EXPECT_LE((found - 1e-3 * f).norm(), 1e-13) << k;
  }
}

TEST(SixBar, OfStephensonIsTwoDyads) {
  const Moving subject = moving_file("planar/stephenson_six_bar.yaml", {"a.wz"});
  const Vec3 b0(20.0, 40.0, 0.0), c0(90.0, 75.0, 0.0), d(100.0, 0.0, 0.0);
  const Vec3 e0(60.0, 110.0, 0.0), f0(150.0, 120.0, 0.0), g(170.0, 10.0, 0.0);

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 720);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_LE(worst_closure_error(solution), 1e-12);
  for (int k = 0; k <= 720; ++k) {
    const Vec3 b = turned(b0, k * kPi / 360.0);
    const Vec3 c = dyad(b, d, (c0 - b0).norm(), (c0 - d).norm(), side_of(b0, d, c0));
    const Vec3 e = carried(e0, b0, c0, b, c);
    const Vec3 f = dyad(e, g, (f0 - e0).norm(), (f0 - g).norm(), side_of(e0, g, f0));
    const Vec3 found = point_at(subject, solution, k, subject.body("lever"), 1e-3 * f0);
    EXPECT_LE((found - 1e-3 * f).norm(), 1e-13) << k;
  }
}

// The disc's centre is e cos t along the first slot, -e sin t along the second.
TEST(Oldham, SlidesByTheOffset) {
  const Moving subject = moving_file("planar/oldham_coupling.yaml", {"a.wz"});
  const double e = 4e-3;
  const double t0 = kPi / 6.0;

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 144);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  const auto s = static_cast<std::size_t>(freedom_index(subject.mechanism, "s.v"));
  for (int k = 0; k <= 144; ++k) {
    const double t = t0 + solution.drive_value(0, k);
    const Configuration configuration = solution.configuration_at(k);
    EXPECT_NEAR(subject.position(configuration, "s.v"), e * (std::cos(t) - std::cos(t0)), 1e-15);
    EXPECT_NEAR(subject.position(configuration, "t.v"), -e * (std::sin(t) - std::sin(t0)), 1e-15);
    EXPECT_NEAR(subject.position(configuration, "b.wz"), t - t0, 1e-12);
    EXPECT_NEAR(*state_at(subject, configuration, 1.0).rate_rates[s], -e * std::cos(t), 1e-14);
  }
}

// The lever points from its foot to the pin of the crank.
TEST(QuickReturn, HasItsSlotInTheLever) {
  const Moving subject = moving_file("planar/quick_return.yaml", {"a.wz"});

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 180);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  for (int k = 0; k <= 180; ++k) {
    const double t = std::atan2(96.0, 72.0) + solution.drive_value(0, k);
    const double lever = std::atan2(120.0 * std::sin(t) + 300.0, 120.0 * std::cos(t));
    EXPECT_NEAR(subject.position(solution.configuration_at(k), "d.wz"),
                lever - std::atan2(396.0, 72.0),
                1e-12);
  }
}

// A disc about (9, 12) with radius 31 under a tip of radius 10: y = ey + √(41² - ex²).
TEST(Cam, LiftsItsRoundFollower) {
  const Moving subject = moving_file("planar/cam_and_follower.yaml", {"a.wz"});

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 360);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_LE(worst_closure_error(solution), 1e-12);
  const auto g = static_cast<std::size_t>(freedom_index(subject.mechanism, "g.vy"));
  for (int k = 0; k <= 360; ++k) {
    const Vec3 e = 1e-3 * turned({9.0, 12.0, 0.0}, k * kPi / 180.0);
    const double q = std::sqrt(0.041 * 0.041 - e.x() * e.x());
    const Configuration configuration = solution.configuration_at(k);
    EXPECT_NEAR(subject.position(configuration, "g.vy"), e.y() + q - 0.052, 1e-14);
    EXPECT_NEAR(*state_at(subject, configuration, 1.0).rates[g], e.x() + e.x() * e.y() / q, 1e-13);
  }
}

}  // namespace
}  // namespace kinestat
