#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/angles.hpp"
#include "unit/motion/moving.hpp"

namespace kinestat {
namespace {

Vec3 turned(const Vec3& axis, double angle, const Vec3& p) {
  return Eigen::AngleAxisd(angle, axis.normalized()) * p;
}

// What is left of A cos φ + B sin φ = C, the condition that a vector turned by φ about an axis has
// the product C with another.
struct TurnCondition {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;

  double missed(double angle) const { return a * std::cos(angle) + b * std::sin(angle) - c; }

  /// Positive while there is an angle.
  double discriminant() const { return a * a + b * b - c * c; }
};

TurnCondition condition(const Vec3& axis, const Vec3& turns, const Vec3& other, double product) {
  const Vec3 n = axis.normalized();
  const Vec3 along = n.dot(turns) * n;
  return {.a = (turns - along).dot(other),
          .b = n.cross(turns).dot(other),
          .c = product - along.dot(other)};
}

// Of a function that falls through zero between the two.
template <class Function>
double root(double low, double high, const Function& value) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (value(middle) > 0.0 ? low : high) = middle;
  }
  return low;
}

// The rod's length gives the rocker's angle by the crank's (Hartenberg and Denavit 1964).
TEST(Rssr, KeepsTheLengthOfItsRodToItsLimit) {
  const Moving subject = moving_file("spatial/rssr.yaml", {"a.wz"});
  const Vec3 b0(0.04, 0.02, 0.0), c0(0.1, 0.08, 0.06), d(0.12, 0.02, 0.04);
  const double rod = (c0 - b0).squaredNorm();
  const auto rocker = [&](double crank) {
    // |c - b|² with c = d + R(c0 - d): the product of R(c0 - d) with b - d.
    const Vec3 b = turned(Vec3::UnitZ(), crank, b0);
    const double product = 0.5 * ((c0 - d).squaredNorm() + (b - d).squaredNorm() - rod);
    return condition(Vec3::UnitY(), c0 - d, b - d, product);
  };

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 360);

  ASSERT_EQ(solution.status, MotionStatus::limit);
  EXPECT_EQ(solution.passive_freedoms.size(), 1U);
  EXPECT_TRUE(solution.open_freedoms.empty());
  for (int k = 0; k < solution.position_count(); ++k) {
    const TurnCondition here = rocker(solution.drive_value(0, k));
    EXPECT_NEAR(here.missed(subject.position(solution.configuration_at(k), "d.wy")), 0.0, 1e-14);
  }
  const double limit = root(1.0, 1.2, [&](double t) { return rocker(t).discriminant(); });
  EXPECT_NEAR(solution.drive_value(0, solution.position_count() - 1), limit, 1e-11);
}

// The axes of b and c keep their angle.
TEST(SphericalFourBar, KeepsTheAngleOfItsCoupler) {
  const Moving subject = moving_file("spatial/spherical_four_bar.yaml", {"a.wz"});
  const Vec3 b0 = Vec3(0.0, 3.0, 4.0) / 5.0;
  const Vec3 c0 = Vec3(3.0, 6.0, 2.0) / 7.0;
  const auto rocker = [&](double crank) {
    return condition({4.0, 0.0, 3.0}, c0, turned(Vec3::UnitZ(), crank, b0), b0.dot(c0));
  };

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 360);

  ASSERT_EQ(solution.status, MotionStatus::limit);
  EXPECT_LE(worst_closure_error(solution), 1e-12);
  for (int k = 0; k < solution.position_count(); ++k) {
    const double angle = subject.position(solution.configuration_at(k), "d.w");
    EXPECT_NEAR(rocker(solution.drive_value(0, k)).missed(angle), 0.0, 1e-12);
  }
  const double limit = root(4.5, 4.7, [&](double t) { return rocker(t).discriminant(); });
  EXPECT_NEAR(solution.drive_value(0, solution.position_count() - 1), limit, 1e-11);
}

// The angle from one link to the next about the axis of their hinge.
double link_angle(const Vec3& axis, const Vec3& before, const Vec3& at, const Vec3& after) {
  const Vec3 n = axis.normalized();
  return std::atan2(n.dot((at - before).cross(after - at)), (at - before).dot(after - at));
}

// Where both legs of a Sarrus linkage are folded, each may swing by itself: a step that ends there
// says so, although the platform goes on.
TEST(Sarrus, SaysWhereItsLegsAreFolded) {
  const Moving subject = moving(
      "ground: frame\nbodies: [l1, l2, m1, m2, top]\ncouplings:\n"
      "  a: {type: revolute, bodies: [frame, l1], at: [1, 0, 0], axis: y}\n"
      "  b: {type: revolute, bodies: [l1, l2], at: [2, 0, 1], axis: y}\n"
      "  c: {type: revolute, bodies: [l2, top], at: [1, 0, 2], axis: y}\n"
      "  d: {type: revolute, bodies: [frame, m1], at: [0, 1, 0], axis: x}\n"
      "  e: {type: revolute, bodies: [m1, m2], at: [0, 2, 1], axis: x}\n"
      "  f: {type: revolute, bodies: [m2, top], at: [0, 1, 2], axis: x}\n",
      {"a.wy"});

  const MotionSolution solution = move(subject, 0.0, kPi / 3.0, 4);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  ASSERT_EQ(solution.special.size(), 1U);
  EXPECT_EQ(solution.special[0].kind, SpecialKind::change_point);
  EXPECT_NEAR(solution.special[0].drive_values[0], kPi / 4.0, 1e-9);
}

// Six figures of its axes are enough: it closes by least squares, and says how well.
TEST(Bennett, MovesAsDrawnWithSixFigures) {
  const Moving subject = moving(
      "ground: frame\nbodies: [k1, k2, k3]\ncouplings:\n"
      "  a: {type: revolute, bodies: [frame, k1], at: [0.0, 0.0, 0.0], axis: [0.0, 0.0, 1.0]}\n"
      "  b: {type: revolute, bodies: [k1, k2], at: [0.540302, 0.841470, 0.0], axis: [0.540887, "
      "-0.347299, 0.766044]}\n"
      "  c: {type: revolute, bodies: [k2, k3], at: [-0.322250, -0.115229, 0.175292], axis: "
      "[-0.134840, 0.294896, 0.945967]}\n"
      "  d: {type: revolute, bodies: [frame, k3], at: [-1.3, 0.0, 0.0], axis: "
      "[0.0, 0.835623, 0.549302]}\n",
      {"a.w"});

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 72);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_LE(worst_closure_error(solution), 1e-5);
}

// Bennett 1903: the tangents of the half angles of neighbouring hinges keep their product.
TEST(Bennett, KeepsTheProductOfItsHalfTangents) {
  const Moving subject = moving_file("spatial/bennett.yaml", {"a.w"});
  const Vec3 a(40.0, 0.0, 20.0), b(20.0, 60.0, -20.0), c(-40.0, 0.0, 20.0), d(-20.0, -60.0, -20.0);
  const double at_a = link_angle({-3.0, 1.0, 3.0}, d, a, b);
  const double at_b = link_angle({0.0, 2.0, 3.0}, a, b, c);

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 90);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_LE(worst_closure_error(solution), 1e-12);
  const double ratio = std::tan(0.5 * at_b) * std::tan(0.5 * at_a);
  for (int k = 0; k <= 90; ++k) {
    const double x = 0.5 * (at_a + solution.drive_value(0, k));
    const double y = 0.5 * (at_b + subject.position(solution.configuration_at(k), "b.w"));
    EXPECT_NEAR(std::sin(x) * std::sin(y), ratio * std::cos(x) * std::cos(y), 1e-12) << k;
  }
}

// Hooke's joint: the shaft between turns cos β / (1 - sin² β cos² t) as fast; both outer alike.
TEST(Cardan, TurnsUnevenlyBetweenItsJoints) {
  const Moving subject = moving_file("spatial/cardan_shaft.yaml", {"A.wz"});
  const double beta = 15.0 * kPi / 180.0;

  const MotionSolution solution = move(subject, 0.0, 4.0 * kPi, 360);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  const BodyId front = subject.body("front");
  const BodyId out = subject.body("out");
  for (int k = 0; k <= 360; ++k) {
    const double t = kPi / 6.0 + solution.drive_value(0, k);
    const double below = 1.0 - std::pow(std::sin(beta) * std::cos(t), 2);
    const MotionState state = state_at(subject, solution.configuration_at(k), 1.0);
    const auto f = static_cast<std::size_t>(front.value);
    const auto o = static_cast<std::size_t>(out.value);
    EXPECT_NEAR(state.twists[f].angular.norm(), std::cos(beta) / below, 1e-12);
    EXPECT_NEAR(state.twist_rates[f].angular.z(),
                -std::pow(std::cos(beta), 2) * std::pow(std::sin(beta), 2) * std::sin(2.0 * t) /
                    (below * below),
                1e-12);
    EXPECT_NEAR(state.twists[o].angular.z(), 1.0, 1e-12);
    EXPECT_NEAR(
        subject.position(solution.configuration_at(k), "B.wz"), solution.drive_value(0, k), 1e-11);
  }
}

// From a pose to the lengths of the legs, and back.
TEST(Platform, ComesToThePoseOfItsLegs) {
  const Moving subject =
      moving_file("spatial/ups_platform.yaml", {"P1.v", "P2.v", "P3.v", "P4.v", "P5.v", "P6.v"});
  BodyPose target;
  target.rotation =
      (Eigen::AngleAxisd(0.2, Vec3::UnitZ()) * Eigen::AngleAxisd(-0.15, Vec3::UnitX()))
          .toRotationMatrix();
  target.shift = {0.1, -0.05, 0.2};
  MotionTask task{.drives = {}, .steps = 25};
  for (int leg = 1; leg <= 6; ++leg) {
    const auto u = static_cast<std::size_t>(subject.coupling(fmt::format("U{}", leg)).value);
    const auto s = static_cast<std::size_t>(subject.coupling(fmt::format("S{}", leg)).value);
    const Vec3& low = subject.mechanism.geometry.points[u];
    const Vec3& high = subject.mechanism.geometry.points[s];
    task.drives.push_back({.freedom = subject.network.driven_freedoms[task.drives.size()],
                           .from = 0.0,
                           .to = (target.point(high) - low).norm() - (high - low).norm()});
  }

  const MotionSolution solution = solve_motion(subject.network, task);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_LE(worst_closure_error(solution), 1e-12);
  const auto poses = body_poses(subject.network, solution.configuration_at(25));
  const BodyPose& found = poses[static_cast<std::size_t>(subject.body("platform").value)];
  EXPECT_LE((found.rotation - target.rotation).norm(), 1e-12);
  EXPECT_LE((found.shift - target.shift).norm(), 1e-12);
}

// The table rises by both panels, and does not turn.
TEST(Sarrus, RisesStraight) {
  const Moving subject = moving_file("spatial/sarrus.yaml", {"a1.wx"});
  const double panel = 0.12 * std::sqrt(2.0);

  const MotionSolution solution = move(subject, 0.0, kPi / 6.0, 60);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  for (int k = 0; k <= 60; ++k) {
    const auto poses = body_poses(subject.network, solution.configuration_at(k));
    const BodyPose& table = poses[static_cast<std::size_t>(subject.body("table").value)];
    const double rise =
        2.0 * panel * (std::sin(kPi / 4.0 + solution.drive_value(0, k)) - std::sin(kPi / 4.0));
    EXPECT_LE((table.shift - Vec3(0.0, 0.0, rise)).norm(), 1e-12);
    EXPECT_LE((table.rotation - Mat3::Identity()).norm(), 1e-12);
  }
}

// tan A tan E = 2 for the angles of the forks (Baker, Duclong and Khoo 1982).
TEST(Schatz, TurnsItsForksByTheirTangents) {
  const Moving subject = moving_file("spatial/schatz_linkage.yaml", {"a.wz"});

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 360);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_LE(worst_closure_error(solution), 1e-12);
  for (int k = 0; k <= 360; ++k) {
    const double A = kPi / 4.0 + solution.drive_value(0, k);
    const double E = std::atan(2.0) + subject.position(solution.configuration_at(k), "f.wz");
    EXPECT_NEAR(std::sin(A) * std::sin(E), 2.0 * std::cos(A) * std::cos(E), 1e-11) << k;
  }
}

// Double thread of 32 x 4: 8 mm a turn, over ten turns.
TEST(ScrewJack, AdvancesByItsLead) {
  const Moving subject = moving_file("spatial/screw_jack.yaml", {"n.w"});

  const MotionSolution solution = move(subject, 0.0, 20.0 * kPi, 40);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_NEAR(subject.position(solution.configuration_at(40), "guide.vz"), 0.08, 1e-13);
}

// The ball of the slipper stays in the plate: z = -r tan(tilt) cos(turn).
TEST(SwashPlate, MovesItsPistonByTheInclinedPlane) {
  const Moving subject = moving_file("spatial/swash_plate_pump.yaml", {"shaft.wz"});
  const double reach = 0.04 * std::tan(18.0 * kPi / 180.0);
  const double t0 = 50.0 * kPi / 180.0;

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 72);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  EXPECT_EQ(solution.passive_freedoms.size(), 2U);
  for (int k = 0; k <= 72; ++k) {
    EXPECT_NEAR(subject.position(solution.configuration_at(k), "bore.vz"),
                -reach * (std::cos(t0 + solution.drive_value(0, k)) - std::cos(t0)),
                1e-14);
  }
}

// A cam of radius 16 about (3, 4) under a flat face: y = ey + radius.
TEST(FlatTappet, RisesWithTheCentreOfItsCam) {
  const Moving subject = moving_file("spatial/flat_tappet.yaml", {"a.wz"});

  const MotionSolution solution = move(subject, 0.0, 2.0 * kPi, 90);

  ASSERT_EQ(solution.status, MotionStatus::completed);
  for (int k = 0; k <= 90; ++k) {
    const double y = 5e-3 * std::sin(std::atan2(4.0, 3.0) + solution.drive_value(0, k));
    EXPECT_NEAR(subject.position(solution.configuration_at(k), "g.vy"), y - 4e-3, 1e-14);
  }
}

}  // namespace
}  // namespace kinestat
