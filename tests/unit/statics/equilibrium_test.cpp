#include "statics/equilibrium.hpp"

#include <gtest/gtest.h>

#include "support/mechanism_text.hpp"
#include "support/near.hpp"

namespace kinestat {
namespace {

// A bar between two pins on the ground at 0 and 4 m: actions a.Rx, a.Ry, b.Rx, b.Ry.
const std::string kPinnedBar =
    "space: planar\nground: base\nbodies: [bar]\ncouplings:\n"
    "  a: {type: revolute, bodies: [base, bar], at: [0, 0]}\n"
    "  b: {type: revolute, bodies: [base, bar], at: [4, 0]}\n";

Equilibrium equilibrium_of_bar(std::vector<int> primaries) {
  return {mechanism_of(kPinnedBar), planar_basis(ScrewKind::wrench, 4.0), std::move(primaries)};
}

BodyWrench push(double x, double fx, double fy) {
  return {.body = BodyId{1},
          .wrench = fx * unit_force(Vec3::UnitX(), Vec3(x, 0.0, 0.0)) +
                    fy * unit_force(Vec3::UnitY(), Vec3(x, 0.0, 0.0))};
}

TEST(Equilibrium, AnswersForOneLoadAfterAnother) {
  const Equilibrium equilibrium = equilibrium_of_bar({0});

  const auto down = equilibrium.solve(std::vector<double>{0.0}, std::vector{push(1.0, 0.0, -8.0)});
  const auto along = equilibrium.solve(std::vector<double>{0.0}, std::vector{push(1.0, 3.0, 0.0)});

  EXPECT_TRUE(is_near(down.magnitudes, Eigen::Vector4d(0.0, 6.0, 0.0, 2.0), 1e-13));
  EXPECT_TRUE(is_near(along.magnitudes, Eigen::Vector4d(0.0, 0.0, -3.0, 0.0), 1e-13));
}

TEST(Equilibrium, AddsUpTheLoadsOnABodyAndThePrimaries) {
  const Equilibrium equilibrium = equilibrium_of_bar({2});

  const EquilibriumActions both = equilibrium.solve(
      std::vector<double>{10.0}, std::vector{push(1.0, 0.0, -8.0), push(1.0, 3.0, 0.0)});

  EXPECT_TRUE(is_near(both.magnitudes, Eigen::Vector4d(-13.0, 6.0, 10.0, 2.0), 1e-13));
  EXPECT_TRUE(both.consistent);
}

TEST(Equilibrium, DoesNotCountWhatActsOnTheGround) {
  const Equilibrium equilibrium = equilibrium_of_bar({0});
  BodyWrench on_ground = push(1.0, 3.0, -8.0);
  on_ground.body = BodyId{0};

  const EquilibriumActions actions =
      equilibrium.solve(std::vector<double>{0.0}, std::vector{on_ground});

  EXPECT_TRUE(is_near(actions.magnitudes, VecX::Zero(4), 0.0));
}

TEST(Equilibrium, HasTheSelfStressOfABarBetweenTwoPins) {
  const std::vector<VecX> stresses = equilibrium_of_bar({}).self_stresses();

  ASSERT_EQ(stresses.size(), 1U);
  EXPECT_TRUE(is_near(stresses[0] / stresses[0][0], Eigen::Vector4d(1.0, 0.0, -1.0, 0.0), kTight));
}

TEST(Equilibrium, CountsCouplesOfASelfStressInSi) {
  // A slider between two guides 4 m apart, in a basis whose unit of length is 4 m: Ry and Tz of
  // each. Two forces 1 N up and down make -4 N·m, which couples bear.
  const Mechanism mechanism = mechanism_of(
      "space: planar\nground: base\nbodies: [block]\ncouplings:\n"
      "  a: {type: prismatic, bodies: [base, block], at: [0, 0], axis: x}\n"
      "  b: {type: prismatic, bodies: [base, block], at: [4, 0], axis: x}\n");

  const std::vector<VecX> stresses =
      Equilibrium(mechanism, planar_basis(ScrewKind::wrench, 4.0), {}).self_stresses();

  ASSERT_EQ(stresses.size(), 2U);
  for (const VecX& stress : stresses) {
    EXPECT_NEAR(stress[0] + stress[2], 0.0, 1e-13);
    EXPECT_NEAR(stress[1] + stress[3] + 4.0 * stress[2], 0.0, 1e-13);
  }
}

}  // namespace
}  // namespace kinestat
