#include "network/node_system.hpp"

#include <gtest/gtest.h>

#include "math/elimination/elimination.hpp"
#include "network/freedom_counts.hpp"
#include "support/mechanism_text.hpp"
#include "support/near.hpp"

namespace kinestat {
namespace {

// One slider on the ground.
Mechanism slider() {
  return mechanism_of(
      "space: planar\nground: base\nbodies: [block]\ncouplings:\n"
      "  a: {type: prismatic, bodies: [base, block], at: [2, 3], axis: x}\n"
      "  b: {type: revolute, bodies: [block, base], at: [2, 3]}\n");
}

TEST(VelocitySystem, SaysThatHeadMinusTailIsTheSumOfTheFreedoms) {
  const Mechanism mechanism = slider();

  const MatX system =
      velocity_system(mechanism.topology, mechanism.geometry, planar_basis(ScrewKind::twist, 1.0))
          .dense();

  // Columns: wz, vx, vy of the block, a.vx, b.wz. The block is the head of a and the tail of b.
  MatX expected(6, 5);
  expected << 1, 0, 0, 0, 0,  //
      0, 1, 0, -1, 0,         //
      0, 0, 1, 0, 0,          //
      -1, 0, 0, 0, -1,        //
      0, -1, 0, 0, -3,        //
      0, 0, -1, 0, 2;
  EXPECT_TRUE(is_near(system, expected, 0.0));
}

TEST(ActionSystem, SaysThatTheActionsOnTheBodyCancel) {
  const Mechanism mechanism = slider();

  const MatX system =
      action_system(mechanism.topology, mechanism.geometry, planar_basis(ScrewKind::wrench, 1.0))
          .dense();

  // Columns: a.Ry, a.Tz, b.Rx, b.Ry; rows Tz, Fx, Fy.
  MatX expected(3, 4);
  expected << 2, 1, 3, -2,  //
      0, 0, -1, 0,          //
      1, 0, 0, -1;
  EXPECT_TRUE(is_near(system, expected, 0.0));
}

TEST(LoadVector, IsMinusTheLoadsOnEachBodyInTheUnitsOfTheBasis) {
  const Wrench push = 3.0 * unit_force(Vec3::UnitY(), Vec3(2.0, 0.0, 0.0));
  const std::vector<BodyWrench> loads = {{.body = BodyId{2}, .wrench = push},
                                         {.body = BodyId{2}, .wrench = push},
                                         {.body = BodyId{0}, .wrench = push}};

  // Tz, Fx, Fy of two bodies; moments count in 4 N·m.
  EXPECT_EQ(load_vector(3, planar_basis(ScrewKind::wrench, 4.0), loads),
            (std::vector<double>{0.0, 0.0, 0.0, -3.0, 0.0, -6.0}));
}

TEST(LoadVector, OfNoLoadsIsEmpty) {
  EXPECT_TRUE(load_vector(3, planar_basis(ScrewKind::wrench, 4.0), {}).empty());
}

TEST(VelocitySystem, HasItsFreedomsBehindTheTwistsOfTheMovingBodies) {
  const Mechanism mechanism = slider();

  EXPECT_EQ(velocity_column(mechanism.topology, planar_basis(ScrewKind::twist, 1.0), 1), 4);
}

TEST(BodyTwist, OfTheGroundIsZero) {
  EXPECT_TRUE(is_near(
      body_twist(VecX::Ones(5), planar_basis(ScrewKind::twist, 1.0), BodyId{0}).coordinates(),
      Vec6::Zero(),
      0.0));
}

TEST(BodyTwist, IsPutTogetherFromTheCoordinatesOfTheBasis) {
  const VecX solution = (VecX(5) << 7, 8, 9, 0, 0).finished();

  const Twist twist = body_twist(solution, planar_basis(ScrewKind::twist, 1.0), BodyId{1});

  EXPECT_EQ(twist.angular, Vec3(0.0, 0.0, 7.0));
  EXPECT_EQ(twist.linear, Vec3(8.0, 9.0, 0.0));
}

TEST(MotionCounts, OfASliderCrankComeFromTheRankOfItsSystem) {
  const Mechanism mechanism = mechanism_of(kSliderCrank);
  const Elimination elimination(
      velocity_system(mechanism.topology, mechanism.geometry, planar_basis(ScrewKind::twist, 1.0)),
      {});

  const MotionCounts counts = motion_counts(mechanism, 3, elimination.rank());

  EXPECT_EQ(counts.rank, 3);
  EXPECT_EQ(counts.net_freedom, 1);
  EXPECT_EQ(counts.net_constraint, 0);
}

TEST(ActionCounts, OfASliderCrankComeFromTheRankOfItsSystem) {
  const Mechanism mechanism = mechanism_of(kSliderCrank);
  const Elimination elimination(
      action_system(mechanism.topology, mechanism.geometry, planar_basis(ScrewKind::wrench, 1.0)),
      {});

  const ActionCounts counts = action_counts(mechanism, 3, elimination.rank());

  EXPECT_EQ(counts.rank, 9);
  EXPECT_EQ(counts.net_constraint, 1);
  EXPECT_EQ(counts.net_freedom, 0);
}

}  // namespace
}  // namespace kinestat
