#include "cases/solve_cases.hpp"

#include <utility>

#include <gtest/gtest.h>

#include "unit/run/mechanism_file.hpp"

namespace kinestat {
namespace {

// The one case of the four-bar linkage: with position a (0, 0), b (1, 3), c (6, 5), d (7, 0) the
// rates of a and d are as 27 : 13 (Cazangi 2008, eq. 3.71).
CaseAnalysis solve(const std::string& text) {
  const MechanismFile file("  one: {" + text + "}\n");
  SourceFile source;
  Diagnostics found;
  std::optional<Loaded> loaded = load(file.path(), {}, source, found);
  if (!loaded) {
    throw std::runtime_error(found.items().front().message);
  }
  return solve_cases(file.path(), *std::move(loaded)).cases.at(0);
}

TEST(SolveCases, RunsNoStaticsForACaseWithoutActions) {
  const CaseAnalysis one = solve("motion: {load: 13 rad/s}");

  EXPECT_FALSE(one.action.has_value());
  EXPECT_FALSE(one.power.has_value());
  ASSERT_TRUE(one.motion.has_value());
  EXPECT_EQ(one.motion->status, SolveStatus::solved);
}

TEST(SolveCases, RunsStaticsForACaseOnWhichALoadActs) {
  const CaseAnalysis one = solve(
      "motion: {load: 13 rad/s}, action: {load: 0}, loads: {push: {body: rocker, couple: 27}}");

  // The drive turns with 27 rad/s where the load turns with 13: 27 T + 13 · 27 = 0.
  ASSERT_TRUE(one.action.has_value());
  ASSERT_EQ(one.action->status, SolveStatus::solved);
  ASSERT_TRUE(one.power.has_value());
  EXPECT_NEAR(one.power->actuators.at(0), -351.0, 1e-9);
  EXPECT_NEAR(one.power->loads.at(0), 351.0, 1e-9);
}

TEST(SolveCases, RunsNoKinematicsForACaseWithoutMotions) {
  const CaseAnalysis one = solve("action: {load: 1 N*m}");

  EXPECT_FALSE(one.motion.has_value());
  EXPECT_FALSE(one.power.has_value());
  ASSERT_TRUE(one.action.has_value());
  EXPECT_EQ(one.action->status, SolveStatus::solved);
}

TEST(SolveCases, FindsPowerOnlyWithBothSidesSolved) {
  EXPECT_TRUE(solve("motion: {load: 13 rad/s}, action: {load: 1 N*m}").power.has_value());
  EXPECT_FALSE(
      solve("motion: {load: 13 rad/s}, action: {load: 1 N*m, drive: 0}").power.has_value());
}

TEST(SolveCases, FindsRatiosOnlyWithInputAndOutput) {
  EXPECT_FALSE(solve("motion: {load: 13 rad/s}, input: drive").ratios.has_value());
  const CaseAnalysis one = solve("motion: {load: 13 rad/s}, input: drive, output: load");

  ASSERT_TRUE(one.ratios.has_value());
  ASSERT_TRUE(one.ratios->ratio.has_value());
  EXPECT_NEAR(*one.ratios->ratio, 27.0 / 13.0, 1e-12);
  EXPECT_FALSE(one.ratios->torque_ratio.has_value());
}

TEST(SolveCases, CountsMobilityOfAPlanarMechanismInSpaceToo) {
  const MechanismFile file("  one: {motion: {load: 1}}\n");
  SourceFile source;
  Diagnostics found;
  std::optional<Loaded> loaded = load(file.path(), {}, source, found);
  ASSERT_TRUE(loaded.has_value());

  const Analysis analysis = solve_cases("four_bar.yaml", *std::move(loaded));

  ASSERT_TRUE(analysis.mobility.planar.has_value());
  EXPECT_EQ(analysis.mobility.planar->motions.net_constraint, 0);
  EXPECT_EQ(analysis.mobility.spatial.motions.net_constraint, 3);
  EXPECT_EQ(analysis.file, "four_bar.yaml");
}

}  // namespace
}  // namespace kinestat
