#include "studies/synthesis/picture/burmester_drawing.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "library_analysis.hpp"
#include "studies/synthesis/picture/burmester_plane.hpp"

namespace kinestat {
namespace {

// Burmester points are where the curves of two choices of four positions meet.
TEST(BurmesterPlane, HasItsDyadsOnBothCurves) {
  const SynthesisAnalysis analysis = library_synthesis("synthesis/crank_rocker.yaml");

  const BurmesterPlane plane = find_plane(analysis.tasks[0]);

  ASSERT_EQ(plane.curves.size(), 2U);
  ASSERT_GE(plane.dyads.size(), 2U);
  for (const DrawnCurves& drawn : plane.curves) {
    for (const DrawnDyad& dyad : plane.dyads) {
      EXPECT_NEAR(drawn.curves.circle_points.miss(dyad.circle_point), 0.0, 1e-9);
      EXPECT_NEAR(drawn.curves.centre_points.miss(dyad.centre_point), 0.0, 1e-9);
    }
  }
}

// The poles of four positions lie on their curve of centre points (Burmester 1888).
TEST(BurmesterPlane, HasThePolesOnTheCurveOfCentrePoints) {
  const SynthesisAnalysis analysis = library_synthesis("synthesis/crank_rocker.yaml");

  const BurmesterPlane plane = find_plane(analysis.tasks[0]);

  ASSERT_EQ(plane.curves[0].without, "5");
  ASSERT_EQ(plane.poles.size(), 10U);
  for (const NamedPoint& pole : plane.poles) {
    if (pole.name.find('5') == std::string::npos) {
      EXPECT_NEAR(plane.curves[0].curves.centre_points.miss(pole.at), 0.0, 1e-9) << pole.name;
    }
  }
}

TEST(BurmesterPlane, HoldsPositionsAndTheChosenDyadsInItsWindow) {
  const SynthesisAnalysis analysis = library_synthesis("synthesis/crank_rocker.yaml");

  const BurmesterPlane plane = find_plane(analysis.tasks[0]);

  for (const PositionJets& position : analysis.tasks[0].positions) {
    EXPECT_TRUE(plane.window.holds(origin(position)));
  }
  for (const DrawnDyad& dyad : plane.dyads) {
    if (dyad.is_chosen) {
      EXPECT_TRUE(plane.window.holds(dyad.circle_point));
      EXPECT_TRUE(plane.window.holds(dyad.centre_point));
    }
  }
}

// The four positions of the crank-rocker with the crank as partner: the known rocker is usable
// until a limit is set below its links.
TEST(Rejection, NamesTheLimitThatALinkageBreaks) {
  const SynthesisAnalysis analysis = library_synthesis("synthesis/crank_rocker.yaml");
  SynthesisTask four = analysis.tasks[0];
  const Dyad one = four.linkages.front().linkage.one;
  const Dyad other = four.linkages.front().linkage.other;
  const Point place = pose_of(four.positions[0]).place(other.circle_point);
  four.positions.pop_back();
  LinkageLimits limits;

  EXPECT_EQ(find_rejection(four.positions, limits, one, place), "");
  limits.size = 2.0;
  EXPECT_EQ(find_rejection(four.positions, limits, one, place), word_of(Defect::size));
}

// The crank of the known crank-rocker turns through the positions as they are numbered; with two of
// them exchanged it does not.
TEST(Rejection, NamesTheOrderInWhichACrankDoesNotCome) {
  const SynthesisAnalysis analysis = library_synthesis("synthesis/crank_rocker.yaml");
  std::vector<PositionJets> four = analysis.tasks[0].positions;
  four.pop_back();
  const Dyad crank = analysis.tasks[0].linkages.front().linkage.one;
  const Point place = pose_of(four[0]).place(crank.circle_point);

  EXPECT_EQ(find_rejection(four, {}, std::nullopt, place), "");
  std::swap(four[1], four[2]);
  EXPECT_EQ(find_rejection(four, {}, std::nullopt, place), word_of(Defect::order));
}

// do Valle 1983, table 5: Ball's point of the first position, by its inflection circle.
TEST(BurmesterPlane, HasBallsPointOnTheInflectionCircle) {
  const SynthesisAnalysis analysis = library_synthesis("synthesis/stationary_curvature.yaml");

  const BurmesterPlane plane = find_plane(analysis.tasks[0]);

  ASSERT_TRUE(plane.circle && plane.ball);
  EXPECT_NEAR(std::abs(*plane.ball - plane.circle->centre), plane.circle->radius, 1e-9);
  EXPECT_NEAR(plane.curves[0].curves.circle_points.miss(*plane.ball), 0.0, 1e-9);
}

TEST(BurmesterDrawing, IsTheSameEveryTime) {
  const SynthesisAnalysis analysis = library_synthesis("synthesis/do_valle_table_1.yaml");

  EXPECT_EQ(draw_burmester(analysis, 0).elements, draw_burmester(analysis, 0).elements);
}

}  // namespace
}  // namespace kinestat
