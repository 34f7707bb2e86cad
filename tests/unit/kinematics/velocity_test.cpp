#include "kinematics/velocity.hpp"

#include <gtest/gtest.h>

#include "support/mechanism_text.hpp"
#include "support/near.hpp"

namespace kinestat {
namespace {

double rate(const Mechanism& mechanism, const KinematicSolution& solution, std::string_view name) {
  return solution.rates.at(static_cast<std::size_t>(freedom_index(mechanism, name)));
}

KinematicSolution solve(const Mechanism& mechanism, const std::vector<Primary>& primaries) {
  return solve_velocity(mechanism, planar_basis(ScrewKind::twist, 1.0), primaries);
}

// The instant centre of the rod is (14, 56/3), above the slider on the line of the crank.
TEST(Velocity, OfTheSliderIsThatOfTheInstantCentre) {
  const Mechanism mechanism = mechanism_of(kSliderCrank);

  const KinematicSolution solution = solve(mechanism, {known_motion(mechanism, "a.wz", 1.0)});

  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(rate(mechanism, solution, "d.vx"), -168.0 / 5.0, 1e-12);
  EXPECT_NEAR(rate(mechanism, solution, "b.wz"), -14.0 / 5.0, 1e-13);
  EXPECT_NEAR(rate(mechanism, solution, "c.wz"), 9.0 / 5.0, 1e-13);
}

TEST(Velocity, OfABodyIsItsTwistRelativeToTheGround) {
  const Mechanism mechanism = mechanism_of(kSliderCrank);

  const KinematicSolution solution = solve(mechanism, {known_motion(mechanism, "a.wz", 1.0)});

  // The rod: -9/5 rad/s about (14, 56/3).
  const Vec6 rod =
      (-9.0 / 5.0 * unit_rotation(Vec3::UnitZ(), {14.0, 56.0 / 3.0, 0.0})).coordinates();
  ASSERT_EQ(solution.bodies.size(), 4U);
  EXPECT_TRUE(is_near(solution.bodies[0].coordinates(), Vec6::Zero(), 0.0));
  EXPECT_TRUE(is_near(solution.bodies[2].coordinates(), rod, 1e-12));
}

TEST(Velocity, OfACouplingIsThatOfItsHeadRelativeToItsTail) {
  const Mechanism mechanism = mechanism_of(kSliderCrank);

  const KinematicSolution solution = solve(mechanism, {known_motion(mechanism, "a.wz", 1.0)});

  const Vec6 b = (-14.0 / 5.0 * unit_rotation(Vec3::UnitZ(), {9.0, 12.0, 0.0})).coordinates();
  EXPECT_TRUE(is_near(solution.couplings.at(1).coordinates(), b, 1e-12));
}

TEST(Velocity, CountsFreedomsAndConstraints) {
  const Mechanism mechanism = mechanism_of(kSliderCrank);

  const KinematicSolution solution = solve(mechanism, {known_motion(mechanism, "a.wz", 1.0)});

  EXPECT_EQ(solution.counts.gross_freedom, 4);
  EXPECT_EQ(solution.counts.rank, 3);
  EXPECT_EQ(solution.counts.net_freedom, 1);
  EXPECT_EQ(solution.counts.net_constraint, 0);
}

TEST(Velocity, WithoutPrimariesIsUnderdeterminedAndNamesTheCompletions) {
  const KinematicSolution solution = solve(mechanism_of(kSliderCrank), {});

  EXPECT_EQ(solution.status, SolveStatus::underdetermined);
  EXPECT_EQ(solution.check.missing, 1);
  EXPECT_EQ(solution.check.completions,
            (std::vector<std::vector<int>>{{0}, {3}, {1}, {2}}));  // actuators at 0 and 3
  EXPECT_TRUE(solution.rates.empty());
}

TEST(Velocity, WithOnePrimaryTooManyIsDependentEvenIfTheyAgree) {
  const Mechanism mechanism = mechanism_of(kSliderCrank);

  const KinematicSolution solution = solve(
      mechanism, {known_motion(mechanism, "a.wz", 1.0), known_motion(mechanism, "d.vx", -33.6)});

  EXPECT_EQ(solution.status, SolveStatus::dependent);
  EXPECT_TRUE(solution.rates.empty());
}

TEST(Velocity, NamesTheRelationBetweenDependentPrimaries) {
  const Mechanism mechanism = mechanism_of(kSliderCrank);

  const KinematicSolution solution = solve(
      mechanism, {known_motion(mechanism, "a.wz", 1.0), known_motion(mechanism, "d.vx", -33.6)});

  // 168/5 a.wz + d.vx = 0, up to a factor.
  ASSERT_EQ(solution.check.dependences.size(), 1U);
  const std::vector<DependenceTerm>& terms = solution.check.dependences[0].terms;
  ASSERT_EQ(terms.size(), 2U);
  EXPECT_EQ(terms[0].index, 0);
  EXPECT_EQ(terms[1].index, 3);
  EXPECT_NEAR(terms[0].coefficient / terms[1].coefficient, 168.0 / 5.0, 1e-12);
}

TEST(Velocity, OfALeverIsInTheRatioOfItsArms) {
  const Mechanism mechanism = mechanism_of(kLever);

  const KinematicSolution solution = solve(mechanism, {known_motion(mechanism, "l.vy", 1.0)});

  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(rate(mechanism, solution, "fulcrum.wz"), -0.5, 1e-14);
  EXPECT_NEAR(rate(mechanism, solution, "r.vy"), -1.5, 1e-14);
}

TEST(Velocity, WithinAStructureIsZeroWithoutPrimaries) {
  const Mechanism truss = mechanism_of(
      "space: planar\nground: base\nbodies: [p, q]\ncouplings:\n"
      "  a: {type: revolute, bodies: [base, p], at: [0, 0]}\n"
      "  b: {type: revolute, bodies: [p, q], at: [1, 2]}\n"
      "  c: {type: revolute, bodies: [q, base], at: [3, 0]}\n");

  const KinematicSolution solution = solve(truss, {});

  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_EQ(solution.rates, (std::vector<double>{0.0, 0.0, 0.0}));
}

TEST(Velocity, OfRigidCouplingsHasNoOrderAndNoMotion) {
  const Mechanism mechanism = mechanism_of(
      "ground: base\nbodies: [p]\ncouplings:\n  a: {type: rigid, bodies: [base, p]}\n");
  const CoordinateBasis none =
      find_minimal_basis(Mat6X(6, 0), ScrewKind::twist, mechanism.geometry.length);

  const KinematicSolution solution = solve_velocity(mechanism, none, {});

  EXPECT_EQ(solution.status, SolveStatus::solved);
  EXPECT_TRUE(is_near(solution.bodies.at(1).coordinates(), Vec6::Zero(), 0.0));
}

}  // namespace
}  // namespace kinestat
