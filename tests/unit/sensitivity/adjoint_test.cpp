#include "studies/sensitivity/adjoint.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sensitivity/dual_solution.hpp"
#include "sensitivity/solved_case.hpp"

namespace kinestat {
namespace {

const std::string kSliderCrank =
    "kinestat: 1\n"
    "space: planar\n"
    "parameters: {r: 0.3, l: 1.1, q: 0.7 rad, reach: 'sqrt(l^2 - (r*sin(q))^2)', w: 2 rad/s}\n"
    "ground: f\n"
    "bodies: [crank, rod, block]\n"
    "couplings:\n"
    "  a: {type: revolute, bodies: [f, crank], at: [0, 0]}\n"
    "  b: {type: revolute, bodies: [crank, rod], at: [r*cos(q), r*sin(q)]}\n"
    "  c: {type: revolute, bodies: [rod, block], at: [r*cos(q) + reach, 0]}\n"
    "  d: {type: prismatic, bodies: [f, block], axis: x}\n"
    "actuators: {drive: {coupling: a}, load: {coupling: d}}\n"
    "cases: {k: {motion: {drive: w}, action: {load: 1}, input: drive, output: load}}\n";

// x = r cos q + s, s² = l² - r² sin² q: ẋ = -w (r sin q + r² sin q cos q / s).
TEST(CaseAdjoint, DifferentiatesTheSpeedOfASliderAsTheClosedForm) {
  const double r = 0.3;
  const double l = 1.1;
  const double q = 0.7;
  const double w = 2.0;
  const double sine = std::sin(q);
  const double cosine = std::cos(q);
  const double s = std::sqrt(l * l - r * r * sine * sine);
  const auto slopes = Solved(kSliderCrank).derivatives_of("d.vx");

  ASSERT_EQ(slopes.size(), 5U);
  EXPECT_NEAR(*slopes[0],
              -w * (sine + 2 * r * sine * cosine / s +
                    r * r * r * sine * sine * sine * cosine / (s * s * s)),
              1e-14);
  EXPECT_NEAR(*slopes[1], w * r * r * sine * cosine * l / (s * s * s), 1e-14);
  EXPECT_NEAR(*slopes[2],
              -w * (r * cosine + r * r * (cosine * cosine - sine * sine) / s +
                    r * r * sine * cosine * r * r * sine * cosine / (s * s * s)),
              1e-14);
  EXPECT_NEAR(*slopes[4], -(r * sine + r * r * sine * cosine / s), 1e-14);
}

TEST(CaseAdjoint, FindsTheTorqueThatBalancesALoadByVirtualWork) {
  const Solved solved(kSliderCrank);
  const auto ratio = solved.derivatives_of("torque_ratio");  // drive / load = -v / w
  const auto speed = solved.derivatives_of("d.vx");

  for (std::size_t p = 0; p < 4; ++p) {
    EXPECT_NEAR(*ratio[p], -*speed[p] / 2.0, 1e-14) << p;
  }
  EXPECT_NEAR(*ratio[4], 0.0, 1e-15);
}

// A spatial loop with every way in which a number enters: points, oblique axes, a pitch, an angle.
const std::string kSpatialLoop =
    "kinestat: 1\n"
    "units: {angle: deg}\n"
    "parameters: {p: 0.2, q: 20 deg, pitch: 3 mm, z: 0.4, w: 1.5 rad/s, F: 7}\n"
    "ground: f\n"
    "bodies: [a, b, c]\n"
    "couplings:\n"
    "  s: {type: spherical, bodies: [a, b], at: [cos(q), sin(q), p]}\n"
    "  t: {type: universal, bodies: [b, c], at: [2, z, 0.5], axes: [[1, p, 0], [0, z, 1]]}\n"
    "  u: {type: cylindrical, bodies: [f, c], at: [2, -0.3, 0], axis: [p, 1, sin(q)]}\n"
    "  v: {type: helical, bodies: [f, a], at: [0, 0, 0], axis: z, pitch: pitch}\n"
    "actuators: {drive: {coupling: v}, push: {coupling: u, freedom: v}, turn: {coupling: u, "
    "freedom: w}}\n"
    "cases: {k: {motion: {drive: w, turn: 0.2}, action: {push: F}}}\n";

// Forward differentiation of the whole solution with dual numbers, by Gauss and dense matrices.
TEST(CaseAdjoint, AgreesWithASolutionInDualNumbers) {
  for (const std::string& text : {kSliderCrank, kSpatialLoop}) {
    const Solved solved(text);
    ASSERT_EQ(solved.motion.status, SolveStatus::solved);
    ASSERT_EQ(solved.action.status, SolveStatus::solved);
    const Topology& topology = solved.mechanism.topology;
    const auto rates = dual_rates(solved.mechanism, solved.derivatives);
    const auto actions = dual_actions(solved.mechanism, solved.derivatives);

    const auto expect_agreement = [&](const std::string& name, const Dual& expected) {
      const auto slopes = solved.derivatives_of(name);
      for (std::size_t p = 0; p < slopes.size(); ++p) {
        ASSERT_TRUE(slopes[p].has_value()) << name << " by " << p;
        const double size = 1.0 + std::abs(derivative(expected, p));
        EXPECT_NEAR(*slopes[p], derivative(expected, p), 1e-11 * size) << name << " by " << p;
      }
    };
    for (int f = 0; f < topology.freedom_count(); ++f) {
      expect_agreement(topology.freedom_name(f), rates[static_cast<std::size_t>(f)]);
    }
    for (int a = 0; a < topology.action_count(); ++a) {
      expect_agreement(topology.action_name(a), actions[static_cast<std::size_t>(a)]);
    }
  }
}

// A parallelogram with a third crank stays movable only while all three are alike.
TEST(CaseAdjoint, HasNoDerivativeWhereRedundantCouplingsWouldNotFit) {
  const Solved solved(
      "kinestat: 1\n"
      "space: planar\n"
      "parameters: {x: 1, y: 2, all: 0}\n"
      "ground: f\n"
      "bodies: [c1, c2, c3, rod]\n"
      "couplings:\n"
      "  a: {type: revolute, bodies: [f, c1], at: [0, 0]}\n"
      "  b: {type: revolute, bodies: [f, c2], at: [3, 0]}\n"
      "  c: {type: revolute, bodies: [f, c3], at: [5, 0]}\n"
      "  d: {type: revolute, bodies: [c1, rod], at: [1 + all, 2]}\n"
      "  e: {type: revolute, bodies: [c2, rod], at: [4 + all, 2]}\n"
      "  g: {type: revolute, bodies: [c3, rod], at: [x + 5 + all, y]}\n"
      "cases: {k: {motion: {a.wz: 1}}}\n");
  const auto slopes = solved.derivatives_of("kinematics/bodies/rod/linear/1");

  EXPECT_FALSE(slopes[0].has_value());
  EXPECT_FALSE(slopes[1].has_value());
  ASSERT_TRUE(slopes[2].has_value());
  EXPECT_NEAR(*slopes[2], 1.0, 1e-14);  // v_y = 1 + all
}

// Two coincident bearings share the force F as they like; the drive holds F p all the same.
TEST(CaseAdjoint, CountsWhatOpenActionsBearTogether) {
  const auto arm = [](const std::string& second) {
    return "kinestat: 1\n"
           "space: planar\n"
           "parameters: {p: 2, q: 2, F: 5}\n"
           "ground: f\n"
           "bodies: [arm]\n"
           "couplings:\n"
           "  a: {type: revolute, bodies: [f, arm], at: [p, 0]}\n"
           "  b: {type: revolute, bodies: [f, arm], at: [" +
           second +
           ", 0]}\n"
           "actuators: {drive: {coupling: a}}\n"
           "loads: {w: {body: arm, at: [0, 0], force: [0, F]}}\n"
           "cases: {k: {motion: {drive: 1}, action: {}}}\n";
  };
  const auto together = Solved(arm("p + 0*q")).derivatives_of("drive");
  const auto apart = Solved(arm("q")).derivatives_of("drive");

  EXPECT_NEAR(*together[0], 5.0, 1e-14);
  EXPECT_NEAR(*together[2], 2.0, 1e-14);
  EXPECT_FALSE(apart[0].has_value());  // then the bearings hold the arm, and the drive is open
  EXPECT_FALSE(apart[1].has_value());
  EXPECT_NEAR(*apart[2], 2.0, 1e-14);
}

TEST(ReportedValue, IsFoundByItsShortNameAndByItsPath) {
  const Solved solved(kSliderCrank);
  const DualCase values = solved.values();

  EXPECT_EQ(find_reported_value(values, "d.vx")->name, "kinematics/freedoms/d.vx");
  EXPECT_EQ(find_reported_value(values, "drive")->name, "statics/actions/drive");
  EXPECT_EQ(find_reported_value(values, "power/supplied/b")->value.value, 0.0);
  EXPECT_EQ(find_reported_value(values, "ratio")->kind, QuantityKind::angular_velocity);
  EXPECT_EQ(find_reported_value(values, "ratio")->per, QuantityKind::velocity);
  for (const char* wrong : {"",
                            "/",
                            "d",
                            "kinematics",
                            "kinematics/bodies/rod/linear/3",
                            "kinematics/bodies/rod/linear/",
                            "statics/couplings/q/force/0",
                            "power/couplings",
                            "kinematics/freedoms/d.vx/0"}) {
    EXPECT_FALSE(find_reported_value(values, wrong)) << wrong;
  }
}

TEST(ReportedValue, AgreesWithTheReport) {
  const Solved solved(kSliderCrank);
  const DualCase values = solved.values();
  const auto value = [&](const char* name) {
    return find_reported_value(values, name)->value.value;
  };
  const std::size_t rod = 2;
  const Vec3 velocity =
      velocity_at(solved.motion.bodies[rod], solved.mechanism.geometry.references[rod]);

  EXPECT_NEAR(value("kinematics/bodies/rod/linear/0"), velocity.x(), 1e-15);
  EXPECT_NEAR(value("kinematics/bodies/rod/twist/2"), solved.motion.bodies[rod].angular.z(), 1e-15);
  EXPECT_NEAR(value("statics/couplings/c/force/0"), solved.action.wrenches[2]->force.x(), 1e-15);
  EXPECT_NEAR(value("power/input"), value("drive") * 2.0, 1e-15);
}

}  // namespace
}  // namespace kinestat
