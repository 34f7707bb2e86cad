#include "studies/synthesis/dyads/given_dyad.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "reference_tasks.hpp"
#include "studies/synthesis/curves/cubic_branches.hpp"
#include "studies/synthesis/curves/curve_point.hpp"
#include "studies/synthesis/dyads/few_positions.hpp"
#include "studies/synthesis/linkages/linkage.hpp"
#include "studies/synthesis/positions/specification.hpp"
#include "support/angles.hpp"

namespace kinestat {
namespace {

// A crank-rocker in five positions: its crank about (0, 0) moves (0.3, -0.2) of the plane.
std::vector<PositionJets> first_positions(std::size_t count) {
  const std::vector<PositionJets>& all = reference_tasks()[0].positions;
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)};
}

const Point kKnownCirclePoint(0.3, -0.2);

// Where the perpendicular bisectors of three points meet.
Point circumcentre(const Point& a, const Point& b, const Point& c) {
  const Point p = b - a;
  const Point q = c - a;
  const Point across = std::norm(q) * p - std::norm(p) * q;
  return a + Point(across.imag(), -across.real()) / (-2.0 * cross(p, q));
}

// The place of a fixed point in the moving frame.
Point seen_from(const PositionJets& position, const Point& fixed) {
  return unit_vector(-position.angle[0]) * (fixed - origin(position));
}

TEST(GivenDyad, OfThreePositionsHasTheCentreOfItsThreePlaces) {
  const std::vector<PositionJets> positions = first_positions(3);
  const Point moving(1.7, 0.9);
  const Point centre = circumcentre(pose_of(positions[0]).place(moving),
                                    pose_of(positions[1]).place(moving),
                                    pose_of(positions[2]).place(moving));

  const CompletedDyad found =
      complete_dyad(positions, {.circle_point = moving, .centre_point = {}});

  ASSERT_TRUE(found.dyad.has_value());
  EXPECT_LT(std::abs(found.dyad->circle_point - moving), 1e-13);
  EXPECT_LT(std::abs(found.dyad->centre_point - centre), 1e-12);
}

// In the moving frame the centre moves about the circle point.
TEST(GivenDyad, OfThreePositionsHasTheCirclePointOfItsCentre) {
  const std::vector<PositionJets> positions = first_positions(3);
  const Point centre(-0.8, 1.1);
  const Point moving = circumcentre(seen_from(positions[0], centre),
                                    seen_from(positions[1], centre),
                                    seen_from(positions[2], centre));

  const CompletedDyad found =
      complete_dyad(positions, {.circle_point = {}, .centre_point = centre});

  ASSERT_TRUE(found.dyad.has_value());
  EXPECT_LT(std::abs(found.dyad->centre_point - centre), 1e-13);
  EXPECT_LT(std::abs(found.dyad->circle_point - moving), 1e-12);
}

// Of PPP a centre of curvature has one point of the plane, by Euler and Savary (do Valle 1983).
TEST(GivenDyad, OfCoincidentPositionsHasThePointOfACentreOfCurvature) {
  const PositionJets position =
      *find_jets({.at = {0.0, 0.0},
                  .angle = 30.0 * kDegree,
                  .pole = Point(3.75, 3.25),
                  .curvature = CurvatureSpecification{{3.0, 2.6}, {0.75, 2.0}, 0.58}})
           .jets;

  const CompletedDyad found =
      complete_dyad(std::vector{position}, {.circle_point = {}, .centre_point = Point(3.0, 2.6)});

  ASSERT_TRUE(found.dyad.has_value());
  EXPECT_LT(std::abs(found.dyad->circle_point), 1e-11);  // E, to which that centre was given
}

TEST(GivenDyad, OfTwoPositionsHasItsCentresOnThePerpendicularBisector) {
  const std::vector<PositionJets> positions = first_positions(2);
  const Point moving(1.7, 0.9);
  const Point one = pose_of(positions[0]).place(moving);
  const Point other = pose_of(positions[1]).place(moving);

  const CompletedDyad found =
      complete_dyad(positions, {.circle_point = moving, .centre_point = {}});

  EXPECT_EQ(found.fault, GivenFault::one_alone);
  EXPECT_EQ(found.which, DyadPoint::centre_point);
  EXPECT_LT(std::abs(*found.instead - 0.5 * (one + other)), 1e-12);
  EXPECT_NEAR(dot(found.along, other - one), 0.0, 1e-12);
}

TEST(GivenDyad, OfTwoPositionsTakesAnyCentreOfThatLine) {
  const std::vector<PositionJets> positions = first_positions(2);
  const Point moving(1.7, 0.9);
  const CompletedDyad line = complete_dyad(positions, {.circle_point = moving, .centre_point = {}});
  const Point centre = *line.instead + 2.5 * line.along;

  const CompletedDyad found =
      complete_dyad(positions, {.circle_point = moving, .centre_point = centre});
  const CompletedDyad beside = complete_dyad(
      positions, {.circle_point = moving, .centre_point = centre + 0.1 * left_of(line.along)});

  ASSERT_TRUE(found.dyad.has_value());
  EXPECT_LT(found.dyad->residual, 1e-12);
  EXPECT_EQ(beside.fault, GivenFault::off_line);
  EXPECT_LT(std::abs(*beside.instead - centre), 1e-12);
  EXPECT_NEAR(beside.distance, 0.1, 1e-12);
}

// A point of PP moves across the line to the pole, on which its centres lie.
TEST(GivenDyad, OfTwoCoincidentPositionsHasItsCentresOnTheLineToThePole) {
  const PositionJets position =
      *find_jets({.at = {1.0, 2.0}, .angle = 0.3, .pole = Point(4.0, -2.0)}).jets;

  const CompletedDyad found =
      complete_dyad(std::vector{position}, {.circle_point = Point(0.0, 0.0), .centre_point = {}});

  EXPECT_EQ(found.fault, GivenFault::one_alone);
  EXPECT_NEAR(cross(found.along, Point(3.0, -4.0)), 0.0, 1e-12);
  EXPECT_NEAR(cross(found.along, *found.instead - Point(1.0, 2.0)), 0.0, 1e-12);
  EXPECT_GT(std::abs(*found.instead - Point(1.0, 2.0)), 0.1);  // a crank with a length
}

TEST(GivenDyad, OfFourPositionsTakesThePivotsOfTheKnownLinkage) {
  const std::vector<PositionJets> positions = first_positions(4);

  const CompletedDyad of_centre =
      complete_dyad(positions, {.circle_point = {}, .centre_point = Point(0.0, 0.0)});
  const CompletedDyad of_circle_point =
      complete_dyad(positions, {.circle_point = kKnownCirclePoint, .centre_point = {}});

  ASSERT_TRUE(of_centre.dyad && of_circle_point.dyad);
  EXPECT_LT(std::abs(of_centre.dyad->circle_point - kKnownCirclePoint), 1e-10);
  EXPECT_LT(std::abs(of_circle_point.dyad->centre_point), 1e-10);
}

// The line to the nearest point stands at right angles on the curve, and no other point is nearer.
TEST(GivenDyad, OffTheCurveOfFourPositionsNamesTheNearestPoint) {
  const std::vector<PositionJets> positions = first_positions(4);
  const PlaneCubic curve = find_curves(positions).centre_points;
  for (const Point& given : {Point(0.4, -0.7), Point(-3.0, 2.0), Point(25.0, 40.0)}) {
    const CompletedDyad found =
        complete_dyad(positions, {.circle_point = {}, .centre_point = given});

    ASSERT_EQ(found.fault, GivenFault::off_curve);
    EXPECT_LT(curve.miss(*found.instead), 1e-12);
    const PlaneCubic local = curve.about(*found.instead, curve.length);
    const Point gradient(local.l[0], local.l[1]);
    const Point away = given - *found.instead;
    EXPECT_NEAR(cross(gradient, away) / std::abs(gradient) / std::abs(away), 0.0, 1e-6);
    EXPECT_NEAR(found.distance, std::abs(away), 1e-12 * std::abs(away));
    for (const CurveBranch& branch : sample(curve, given, 2.0 * found.distance, 3000)) {
      for (const Point& p : branch.points) {
        EXPECT_GE(std::abs(p - given), found.distance * (1.0 - 1e-12));
      }
    }
  }
}

// As it is read off a report, in six figures.
TEST(GivenDyad, PutsRightWhatItsDecimalsExplain) {
  const std::vector<PositionJets> positions = first_positions(4);
  const CompletedDyad exact =
      complete_dyad(positions, {.circle_point = {}, .centre_point = Point(0.4, -0.7)});
  const auto rounded = [](double x) { return std::round(1e4 * x) / 1e4; };
  const Point typed(rounded(exact.instead->real()), rounded(exact.instead->imag()));

  const CompletedDyad found =
      complete_dyad(positions, {.circle_point = {}, .centre_point = typed, .rounding = 7.1e-5});
  const CompletedDyad strict =
      complete_dyad(positions, {.circle_point = {}, .centre_point = typed});

  ASSERT_TRUE(found.dyad.has_value());
  EXPECT_LT(found.dyad->residual, 1e-11);
  EXPECT_LT(std::abs(found.dyad->centre_point - typed), 7.1e-5);
  EXPECT_EQ(strict.fault, GivenFault::off_curve);
}

// As another program works it out: it may have no decimals, and all digits of a double.
TEST(GivenDyad, TakesAPointThatIsOffByLessThanReportsShow) {
  const std::vector<PositionJets> positions = first_positions(4);
  const Point on_curve =
      *complete_dyad(positions, {.circle_point = {}, .centre_point = Point(0.4, -0.7)}).instead;
  for (const double off : {1e-13, 1e-11, 5e-10}) {
    const CompletedDyad found =
        complete_dyad(positions, {.circle_point = {}, .centre_point = on_curve + Point(off, -off)});

    ASSERT_TRUE(found.dyad.has_value()) << off;
    EXPECT_LT(found.dyad->residual, 1e-11) << off;
  }
  EXPECT_EQ(complete_dyad(positions, {.circle_point = {}, .centre_point = on_curve + 1e-6}).fault,
            GivenFault::off_curve);
}

// No point keeps its distance from a centre while the plane moves along a line.
TEST(GivenDyad, OfAStraightTranslationHasNoCrank) {
  const std::vector<PositionJets> positions = {finite_position({0.0, 0.0}, 0.4),
                                               finite_position({1.0, 0.0}, 0.4),
                                               finite_position({2.0, 0.0}, 0.4)};

  const CompletedDyad found =
      complete_dyad(positions, {.circle_point = {}, .centre_point = Point(1.0, 1.0)});

  EXPECT_FALSE(found.dyad && found.dyad->kind == DyadKind::crank);
}

}  // namespace
}  // namespace kinestat
