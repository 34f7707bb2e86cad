#include "studies/mobility/redundancy.hpp"

#include <cmath>

#include "mobility_case.hpp"
#include "network/bases.hpp"

namespace kinestat {
namespace {

// Forces and couples of the coupling on its head sum to zero on every moving body, about the
// origin.
void expect_equilibrium(const Mechanism& mechanism, const RedundantConstraint& one) {
  std::vector<Vec6> sums(mechanism.topology.bodies.size(), Vec6::Zero());
  double largest = 0.0;
  for (std::size_t e = 0; e < one.wrenches.size(); ++e) {
    const CouplingTopology& coupling = mechanism.topology.couplings[e];
    const Vec6 wrench = one.wrenches[e].coordinates();
    largest = std::max(largest, wrench.cwiseAbs().maxCoeff());
    sums[static_cast<std::size_t>(coupling.head.value)] += wrench;
    sums[static_cast<std::size_t>(coupling.tail.value)] -= wrench;
  }
  for (const Vec6& sum : sums) {
    EXPECT_LE(sum.cwiseAbs().maxCoeff(), 1e-12 * largest);
  }
  EXPECT_GT(largest, 0.0);
}

// Nothing that moves does work on it.
void expect_no_work(const Mechanism& mechanism, const RedundantConstraint& one) {
  for (int f = 0; f < mechanism.topology.freedom_count(); ++f) {
    const auto index = static_cast<std::size_t>(f);
    const CouplingId coupling = mechanism.topology.freedoms[index].coupling;
    const Wrench& wrench = one.wrenches[static_cast<std::size_t>(coupling.value)];
    EXPECT_NEAR(power(wrench, mechanism.geometry.motions[index]), 0.0, 1e-12);
  }
}

Redundancies redundancies_of(const std::string& name) {
  return case_of_library(name).exact().spatial;
}

// The errata: three, where Alves 2023, line 462 prints two.
TEST(Redundancy, OfAPlanarFourBarInSpaceIsAForceAndTwoCouples) {
  const Redundancies found = redundancies_of("planar/four_bar");

  ASSERT_EQ(found.net_constraint, 3);
  ASSERT_EQ(found.constraints.size(), 3U);
  EXPECT_EQ(found.constraints[0].axis->direction.cwiseAbs(), Vec3::UnitZ());
  EXPECT_EQ(found.constraints[0].axis->pitch, 0.0);
  EXPECT_TRUE(found.constraints[0].is_line_free);
  EXPECT_EQ(found.constraints[1].axis->direction.cwiseAbs(), Vec3::UnitX());
  EXPECT_FALSE(found.constraints[1].axis->pitch.has_value());
  EXPECT_EQ(found.constraints[2].axis->direction.cwiseAbs(), Vec3::UnitY());
  EXPECT_FALSE(found.constraints[2].axis->pitch.has_value());
}

TEST(Redundancy, OfASarrusLinkageIsACoupleAboutTheDirectionThatNoHingeHas) {
  const Redundancies found = redundancies_of("spatial/sarrus");

  ASSERT_EQ(found.constraints.size(), 1U);
  EXPECT_EQ(found.constraints[0].axis->direction.cwiseAbs(), Vec3::UnitZ());
  EXPECT_FALSE(found.constraints[0].axis->pitch.has_value());
}

// Forces through the point where all axes meet have no moment about any.
TEST(Redundancy, OfASphericalLinkageAreForcesThroughItsCentre) {
  const Redundancies found = redundancies_of("spatial/spherical_four_bar");

  ASSERT_EQ(found.constraints.size(), 3U);
  for (const RedundantConstraint& one : found.constraints) {
    EXPECT_EQ(one.axis->pitch, 0.0);
    EXPECT_TRUE(one.axis->point->isZero(1e-12));
    EXPECT_FALSE(one.is_line_free);
  }
}

class RedundancyOf : public ::testing::TestWithParam<const char*> {};

TEST_P(RedundancyOf, IsInEquilibriumAndDoesNoWork) {
  const MobilityCase one = case_of_library(GetParam());
  const ExactMobility exact = one.exact();

  ASSERT_FALSE(exact.spatial.constraints.empty());
  for (const RedundantConstraint& constraint : exact.spatial.constraints) {
    expect_equilibrium(one.in_space, constraint);
    expect_no_work(one.in_space, constraint);
  }
}

INSTANTIATE_TEST_SUITE_P(Library,
                         RedundancyOf,
                         ::testing::Values("planar/four_bar",
                                           "planar/watt_six_bar",
                                           "planar/stephenson_six_bar",
                                           "planar/braced_frame",
                                           "spatial/bennett",
                                           "spatial/schatz_linkage",
                                           "spatial/four_legged_table"));

// Six bars between four joints, a square with both diagonals: one more than 2 · 4 - 3. Closed form:
// sides 1, diagonals -sqrt(2) (Timoshenko, Strength of Materials, part I).
TEST(Redundancy, ThroughSeveralCircuitsHasSharesOfItsFirstAction) {
  const MobilityCase one = case_of_library("planar/braced_frame");

  const Redundancies found = one.exact().spatial;

  ASSERT_EQ(found.constraints.size(), 1U);
  const RedundantConstraint& stress = found.constraints[0];
  EXPECT_FALSE(stress.chord.has_value());
  const double root = std::sqrt(2.0);
  for (const auto& [action, share] : std::vector<std::pair<std::string, double>>{
           {"ad.R", 1.0}, {"bd.R", -root}, {"dc.R", 1.0}, {"bc.R", 1.0}, {"ac.R", -root}}) {
    for (int a = 0; a < one.in_space.topology.action_count(); ++a) {
      if (one.in_space.topology.action_name(a) == action) {
        EXPECT_NEAR(stress.magnitudes[a], share, 1e-12) << action;
      }
    }
  }
}

TEST(Redundancy, OfRollingTeethBelongsToTheModel) {
  const Redundancies found = redundancies_of("transmissions/ravigneaux");

  EXPECT_EQ(found.net_constraint, 21);  // 6 · 5 - 9
  EXPECT_EQ(found.borne, 0);
}

TEST(Redundancy, InThePlaneIsWhatParallelLinksShare) {
  // Three equal parallel cranks carry a platform: one of the two outer ones would do.
  const MobilityCase one = case_of_text(
      "space: planar\nground: f\nbodies: [p, q, r, table]\ncouplings:\n"
      "  a: {type: revolute, bodies: [f, p], at: [0, 0]}\n"
      "  b: {type: revolute, bodies: [f, q], at: [2, 0]}\n"
      "  c: {type: revolute, bodies: [f, r], at: [5, 0]}\n"
      "  d: {type: revolute, bodies: [p, table], at: [1, 3]}\n"
      "  e: {type: revolute, bodies: [q, table], at: [3, 3]}\n"
      "  g: {type: revolute, bodies: [r, table], at: [6, 3]}\n");

  const ExactMobility exact = one.exact();

  EXPECT_EQ(exact.counts.planar->motions.net_freedom, 1);
  ASSERT_EQ(exact.planar->constraints.size(), 1U);
  EXPECT_EQ(exact.spatial.net_constraint, 7);
  EXPECT_EQ(exact.spatial.constraints.size(), 7U);
}

}  // namespace
}  // namespace kinestat
