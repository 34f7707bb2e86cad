#include "studies/mobility/motion_space.hpp"

#include <cmath>

#include "mobility_case.hpp"
#include "network/bases.hpp"
#include "screw/screw_axis.hpp"
#include "studies/mobility/passive_freedom.hpp"
#include "support/mechanism_text.hpp"

namespace kinestat {
namespace {

MotionSpace motions_of(const Mechanism& mechanism) {
  return find_motion_space(mechanism, motion_basis(mechanism.geometry, OrderChoice::minimal));
}

double rate(const Mechanism& mechanism, const FreeMotion& motion, std::string_view freedom) {
  return motion.rates[freedom_index(mechanism, freedom)];
}

// Cazangi 2008, eq. 3.71 with the numbers of the file: rates as 27 : -35 : 21 : 13.
TEST(MotionSpace, OfAFourBarIsItsOneMotion) {
  const Mechanism mechanism = case_of_library("planar/four_bar").mechanism;

  const MotionSpace space = motions_of(mechanism);

  ASSERT_EQ(space.net_freedom, 1);
  ASSERT_EQ(space.motions.size(), 1U);
  EXPECT_EQ(rate(mechanism, space.motions[0], "a.wz"), 1.0);
  EXPECT_NEAR(rate(mechanism, space.motions[0], "b.wz"), -35.0 / 27.0, 1e-12);
  EXPECT_NEAR(rate(mechanism, space.motions[0], "d.wz"), 13.0 / 27.0, 1e-12);
  EXPECT_FALSE(space.motions[0].is_passive());
}

// The coupler turns about the point where the lines of crank and rocker meet: (35/8, 105/8).
TEST(MotionSpace, HasTheInstantaneousCentreOfTheCoupler) {
  const Mechanism mechanism = case_of_library("planar/four_bar").mechanism;
  const MotionSpace space = motions_of(mechanism);

  const auto axis = find_axis(space.motions[0].bodies[2], mechanism.geometry.length);

  ASSERT_TRUE(axis && axis->point);
  EXPECT_NEAR(axis->point->x(), 35.0 / 8.0, 1e-12);
  EXPECT_NEAR(axis->point->y(), 105.0 / 8.0, 1e-12);
  EXPECT_EQ(axis->pitch, 0.0);
}

// Sarrus 1853: the table rises without turning.
TEST(MotionSpace, LiftsTheTableOfSarrusStraight) {
  const Mechanism mechanism = case_of_library("spatial/sarrus").mechanism;
  const MotionSpace space = motions_of(mechanism);
  int table = 0;
  while (mechanism.topology.bodies[static_cast<std::size_t>(table)].name != "table") {
    ++table;
  }

  const auto axis = find_axis(space.motions[0].bodies[static_cast<std::size_t>(table)],
                              mechanism.geometry.length);

  ASSERT_TRUE(axis.has_value());
  EXPECT_FALSE(axis->pitch.has_value());
  EXPECT_TRUE(axis->direction.cwiseAbs().isApprox(Vec3(Vec3::UnitZ()), 1e-12));
}

// The rod spins about the line of its ball joints, (1, 1, 1) by the file's coordinates.
TEST(MotionSpace, TellsTheSpinOfARodApart) {
  const Mechanism mechanism = case_of_library("spatial/rssr").mechanism;

  const MotionSpace space = motions_of(mechanism);

  ASSERT_EQ(space.motions.size(), 2U);
  EXPECT_FALSE(space.motions[0].is_passive());
  EXPECT_NE(rate(mechanism, space.motions[0], "d.wy"), 0.0);
  const FreeMotion& spin = space.motions[1];
  ASSERT_TRUE(spin.is_passive());
  EXPECT_EQ(mechanism.topology.body(spin.passive.at(0)).name, "rod");
  EXPECT_EQ(rate(mechanism, spin, "a.wz"), 0.0);
  EXPECT_EQ(rate(mechanism, spin, "d.wy"), 0.0);
  const auto axis = find_axis(spin.bodies[2], mechanism.geometry.length);
  EXPECT_TRUE(axis->direction.isApprox(Vec3::Ones().normalized(), 1e-12));
  EXPECT_EQ(axis->pitch, 0.0);
}

// A leg of two bodies between ball joints turns as a whole; between a ball and a gimbal it cannot.
std::string leg(const std::string& base_joint) {
  return "ground: base\nbodies: [lower, upper, platform]\ncouplings:\n"
         "  B: {" +
         base_joint +
         ", bodies: [base, lower], at: [1, 0, 0]}\n"
         "  P: {type: prismatic, bodies: [lower, upper], at: [1, 1, 1], axis: [0, 1, 2]}\n"
         "  S: {type: spherical, bodies: [upper, platform], at: [1, 2, 4]}\n"
         "  hold: {type: prismatic, bodies: [base, platform], axis: z}\n"
         "actuators:\n  drive: {coupling: P}\n";
}

TEST(MotionSpace, TellsTheSpinOfALegOfTwoBodies) {
  const Mechanism mechanism = case_of_text(leg("type: spherical")).mechanism;

  const MotionSpace space = motions_of(mechanism);

  ASSERT_EQ(space.net_freedom, 2);
  ASSERT_TRUE(space.motions[1].is_passive());
  EXPECT_EQ(space.motions[1].passive.size(), 2U);
}

TEST(MotionSpace, HasNoSpinOfALegOnAGimbal) {
  const Mechanism mechanism = case_of_text(leg("type: universal, axes: [x, y]")).mechanism;

  const MotionSpace space = motions_of(mechanism);

  ASSERT_EQ(space.net_freedom, 1);
  EXPECT_FALSE(space.motions[0].is_passive());
}

TEST(MotionSpace, HasSixMotionsOfAPlatformNoneOfThemPassive) {
  const MotionSpace space = motions_of(case_of_library("spatial/ups_platform").mechanism);

  ASSERT_EQ(space.motions.size(), 6U);
  for (const FreeMotion& motion : space.motions) {
    EXPECT_FALSE(motion.is_passive());
  }
}

// The lower part of a leg turns about the centre of its universal joint, a point of the ground: no
// screw of it has a pitch.
TEST(MotionSpace, GivesWhatTurnsAboutAPointNoPitch) {
  const Mechanism mechanism = case_of_library("spatial/ups_platform").mechanism;

  const MotionSpace space = motions_of(mechanism);

  int turning = 0;
  for (std::size_t b = 1; b < mechanism.topology.bodies.size(); ++b) {
    for (const FreeMotion& motion : space.motions) {
      const auto axis = motion.axis_of(b, mechanism.geometry.length);
      if (mechanism.topology.bodies[b].name.starts_with("lower") && axis) {
        ++turning;
        EXPECT_EQ(axis->pitch, 0.0);
      }
    }
  }
  EXPECT_GT(turning, 30);
}

// A shaft in two bearings on the ground turns: that is what it is for.
TEST(PassiveFreedom, IsNoMotionAgainstTheGroundAlone) {
  const MobilityCase one = case_of_text(
      "ground: f\nbodies: [shaft]\ncouplings:\n"
      "  a: {type: revolute, bodies: [f, shaft], at: [0, 0, 0], axis: z}\n"
      "  b: {type: cylindrical, bodies: [f, shaft], at: [0, 0, 1], axis: z}\n");

  EXPECT_TRUE(find_passive_freedoms(one.mechanism, spatial_basis(ScrewKind::twist, 1.0)).empty());
}

}  // namespace
}  // namespace kinestat
