#include "statics/action.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "screw/screw_axis.hpp"
#include "support/mechanism_text.hpp"
#include "support/near.hpp"
#include "unit/statics/magnitude.hpp"

namespace kinestat {
namespace {

StaticSolution solve(const Mechanism& mechanism, const std::vector<Primary>& primaries) {
  return solve_action(mechanism, planar_basis(ScrewKind::twist, 1.0), primaries);
}

// A bar on two supports, both fixed: one horizontal force too many.
const std::string kBar =
    "space: planar\nground: base\nbodies: [bar]\ncouplings:\n"
    "  a: {type: revolute, bodies: [base, bar], at: [0, 0]}\n"
    "  b: {type: revolute, bodies: [base, bar], at: [4, 0]}\n";

TEST(Action, InASliderCrankBalancesThePiston) {
  const Mechanism mechanism = mechanism_of(kSliderCrank);

  const StaticSolution solution = solve(mechanism, {known_action(mechanism, "Fout", -1.0)});

  // The rod is in line with its force (1, -12/5); the torque is the force's moment about a.
  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "Tin"), -168.0 / 5.0, 1e-12);
  EXPECT_NEAR(magnitude(mechanism, solution, "b.Rx"), 1.0, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "b.Ry"), -12.0 / 5.0, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "d.Ry"), 12.0 / 5.0, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "d.Tz"), 0.0, 1e-12);
}

TEST(Action, OfALeverIsInTheInverseRatioOfItsArms) {
  const Mechanism mechanism = mechanism_of(kLever);

  const StaticSolution solution = solve(mechanism, {known_action(mechanism, "push", 3.0)});

  // Both push down on the lever's ends or up: 3 N · 2 m = 2 N · 3 m.
  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(mechanism, solution, "load"), 2.0, 1e-13);
  EXPECT_NEAR(magnitude(mechanism, solution, "fulcrum.Ry"), -5.0, 1e-13);
}

TEST(Action, OfACouplingIsItsWrenchFromTailOnHead) {
  const Mechanism mechanism = mechanism_of(kSliderCrank);

  const StaticSolution solution = solve(mechanism, {known_action(mechanism, "Fout", -1.0)});

  const Vec6 b = (unit_force(Vec3::UnitX(), {9.0, 12.0, 0.0}) +
                  -12.0 / 5.0 * unit_force(Vec3::UnitY(), {9.0, 12.0, 0.0}))
                     .coordinates();
  ASSERT_TRUE(solution.wrenches.at(1).has_value());
  EXPECT_TRUE(is_near(solution.wrenches[1]->coordinates(), b, 1e-12));
}

TEST(Action, CountsConstraintsAndFreedoms) {
  const Mechanism mechanism = mechanism_of(kSliderCrank);

  const StaticSolution solution = solve(mechanism, {known_action(mechanism, "Fout", -1.0)});

  EXPECT_EQ(solution.counts.gross_constraint, 10);
  EXPECT_EQ(solution.counts.rank, 9);
  EXPECT_EQ(solution.counts.net_constraint, 1);
  EXPECT_EQ(solution.counts.net_freedom, 0);
}

TEST(Action, InARedundantBarLeavesOnlyTheSelfStressOpen) {
  const Mechanism bar = mechanism_of(kBar);

  const StaticSolution solution = solve(bar, {});

  // Actions a.Rx, a.Ry, b.Rx, b.Ry: the bar may be stretched, so a.Rx and b.Rx are open.
  EXPECT_EQ(solution.status, SolveStatus::underdetermined);
  EXPECT_EQ(solution.check.missing, 1);
  EXPECT_EQ(solution.check.undetermined, (std::vector<int>{0, 2}));
  EXPECT_EQ(solution.check.completions, (std::vector<std::vector<int>>{{0}, {2}}));
  EXPECT_FALSE(solution.magnitudes.at(0).has_value());
  EXPECT_EQ(solution.magnitudes.at(1), std::optional(0.0));
}

TEST(Action, OfACouplingIsEmptyWhereOneOfItsActionsIsOpen) {
  const StaticSolution solution = solve(mechanism_of(kBar), {});

  EXPECT_FALSE(solution.wrenches.at(0).has_value());
}

TEST(Action, WithAPrimarySelfStressIsSolved) {
  const Mechanism bar = mechanism_of(kBar);

  const StaticSolution solution = solve(bar, {known_action(bar, "a.Rx", 7.0)});

  ASSERT_EQ(solution.status, SolveStatus::solved);
  EXPECT_NEAR(magnitude(bar, solution, "b.Rx"), -7.0, 1e-14);
}

TEST(Action, WithSurplusPrimariesThatAgreeIsDependent) {
  const Mechanism bar = mechanism_of(kBar);

  const StaticSolution solution =
      solve(bar, {known_action(bar, "a.Rx", 7.0), known_action(bar, "b.Rx", -7.0)});

  EXPECT_EQ(solution.status, SolveStatus::dependent);
  EXPECT_TRUE(solution.magnitudes.empty());
}

TEST(Action, WithSurplusPrimariesThatContradictIsInconsistent) {
  const Mechanism bar = mechanism_of(kBar);

  const StaticSolution solution =
      solve(bar, {known_action(bar, "a.Rx", 7.0), known_action(bar, "b.Rx", 7.0)});

  EXPECT_EQ(solution.status, SolveStatus::inconsistent);
  EXPECT_TRUE(solution.magnitudes.empty());
}

TEST(UnconstrainedMotion, OfADrivenArmIsItsTurnAboutItsAxis) {
  const Mechanism arm = mechanism_of(
      "space: planar\nground: base\nbodies: [arm]\ncouplings:\n"
      "  a: {type: revolute, bodies: [base, arm], at: [3, 4]}\n"
      "actuators:\n  motor: {coupling: a}\n");

  const StaticSolution solution = solve(arm, {known_action(arm, "motor", 1.0)});

  EXPECT_EQ(solution.status, SolveStatus::inconsistent);
  ASSERT_TRUE(solution.unconstrained.has_value());
  EXPECT_EQ(solution.unconstrained->body, BodyId{1});
  const auto axis = find_axis(solution.unconstrained->twist, arm.geometry.length);
  ASSERT_TRUE(axis && axis->point && axis->pitch);
  EXPECT_TRUE(is_near(axis->direction.cwiseAbs(), Vec3(0.0, 0.0, 1.0), kTight));
  EXPECT_TRUE(is_near(*axis->point, Vec3(3.0, 4.0, 0.0), kTight));
}

// Of two sliders, only the second is pushed.
TEST(UnconstrainedMotion, IsThatOfTheBodyThatIsPushed) {
  const Mechanism sliders = mechanism_of(
      "ground: base\nbodies: [first, second]\ncouplings:\n"
      "  a: {type: prismatic, bodies: [base, first], axis: x}\n"
      "  b: {type: prismatic, bodies: [base, second], axis: y}\n"
      "actuators:\n  p: {coupling: a}\n  q: {coupling: b}\n");

  const StaticSolution solution = solve_action(
      sliders,
      spatial_basis(ScrewKind::twist, 1.0),
      std::vector<Primary>{known_action(sliders, "p", 0.0), known_action(sliders, "q", 2.0)});

  EXPECT_EQ(solution.status, SolveStatus::inconsistent);
  ASSERT_TRUE(solution.unconstrained.has_value());
  EXPECT_EQ(solution.unconstrained->body, BodyId{2});
  EXPECT_TRUE(
      is_near(solution.unconstrained->twist.linear.cwiseAbs(), Vec3(0.0, 1.0, 0.0), kTight));
  EXPECT_TRUE(is_near(solution.unconstrained->twist.angular, Vec3::Zero(), kTight));
}

}  // namespace
}  // namespace kinestat
