#include "studies/synthesis/positions/specification.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "near_dyad.hpp"
#include "reference_tasks.hpp"
#include "studies/synthesis/dyads/burmester.hpp"
#include "studies/synthesis/positions/special_frame.hpp"
#include "support/angles.hpp"

namespace kinestat {
namespace {

PositionSpecification table_5() {
  return {.at = {0.0, 0.0},
          .angle = 0.0,
          .pole = Point(3.75, 3.25),
          .curvature = CurvatureSpecification{{3.0, 2.6}, {0.75, 2.0}, 0.58}};
}

void expect_jets(const PositionJets& found, const PositionJets& expected) {
  ASSERT_EQ(found.order(), expected.order());
  for (int k = 0; k < found.order(); ++k) {
    EXPECT_LT(relative(origin(found, k), origin(expected, k)), 1e-13) << "derivative " << k;
  }
}

// do Valle 1983, eqs. 2.8 and 2.9.
TEST(Specification, OfAPoleGivesTheTangent) {
  const auto found = find_jets({.at = {0.424, 0.245}, .angle = 0.5, .pole = Point(0.6, 2.019)});

  ASSERT_TRUE(found.jets);
  EXPECT_EQ(found.jets->order(), 2);
  EXPECT_LT(std::abs(origin(*found.jets, 1) - Point(1.774, -0.176)), 1e-15);
}

// do Valle 1983, table 5 (and tables 3 and 4 at another angle): α2, β2 by D . e = j.
TEST(Specification, OfCurvatureGivesTheSecondDerivatives) {
  PositionSpecification given = table_5();
  given.angle = 30.0 * kDegree;

  const auto found = find_jets(given);

  ASSERT_TRUE(found.jets);
  expect_jets(*found.jets, reference_task("table3").positions[0]);
}

TEST(Specification, OfStationaryCurvatureGivesTheThirdDerivatives) {
  PositionSpecification given = table_5();
  given.is_stationary = true;

  const auto found = find_jets(given);

  ASSERT_TRUE(found.jets);
  expect_jets(*found.jets, reference_task("table5").positions[0]);
}

TEST(Specification, OfBurmesterPointsGivesTheFourthDerivatives) {
  PositionSpecification given = table_5();
  given.is_stationary = true;
  given.is_burmester = true;

  const auto found = find_jets(given);

  ASSERT_TRUE(found.jets);
  expect_jets(*found.jets, reference_task("case1_PPPPP").positions[0]);
}

// Positions that break the quadrant rules, divisions and unsigned lengths of the source. The
// moving frame of the expected derivatives has its origin in (0, 0); 60 digits.
struct OddSpecification {
  std::string name;
  PositionSpecification given;
  std::vector<double> x;
  std::vector<double> y;
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();

PositionSpecification burmester(Point e, Point f, Point centre, Point pole, double m) {
  return {.at = e,
          .angle = 0.0,
          .pole = pole,
          .curvature = CurvatureSpecification{centre, f, m},
          .is_stationary = true,
          .is_burmester = true};
}

const Point kCentre{-11.0 / 9.0, 1.0 / 9.0};

std::vector<OddSpecification> odd_specifications() {
  return {
      {"PointOnThePoleTangent",
       burmester({3.0, 1.0}, {2.0, 2.5}, {1.0, 1.0}, {1.0, 1.0}, 0.4),
       {0.0, 1.0, 1.0, 8.75, -55.84375},
       {0.0, -1.0, -2.25, 10.75, -30.25}},
      {"FreePointOnThePoleNormal",
       burmester({2.0, 1.4}, {1.0, 2.2}, kCentre, {1.0, 1.0}, -1.5),
       {0.0, 1.0, 1.0, -2.8620689655172415, -5.6119698771304005},
       {0.0, -1.0, 3.0, 1.0, 0.632183908045977}},
      {"FreePointOnAStraightPath",
       burmester({2.0, 1.4}, {2.0, 2.0}, kCentre, {1.0, 1.0}, kInfinity),
       {0.0, 1.0, 1.0, -4.103448275862069, -13.713436385255648},
       {0.0, -1.0, 3.0, 4.103448275862069, 9.713436385255648}},
      {"CentreBehindTheFreePoint",
       burmester({2.0, 1.4}, {0.2, 1.9}, kCentre, {1.0, 1.0}, -0.7),
       {0.0, 1.0, 0.43559718969555034, -0.37721419086868546, -19.011974715089664},
       {0.0, -1.0, 4.4110070257611245, -9.021855906176425, 49.80665254616527}},
      {"CentreBeyondThePole",
       burmester({2.0, 1.4}, {0.2, 1.9}, kCentre, {1.0, 1.0}, 1.8),
       {0.0, 1.0, 1.378870673952641, -2.265602052209286, -2.391582137651872},
       {0.0, -1.0, 2.052823315118397, 2.0662097659104397, -3.5910169814238966}},
      {"PoleOnAnAxis",
       burmester({1.0, 2.4}, {-0.8, 2.9}, {-20.0 / 9.0, 10.0 / 9.0}, {0.0, 2.0}, 0.6),
       {0.0, 2.0, 0.907103825136612, -2.554074884084429, -2.5011591561449085},
       {0.0, 0.0, 1.7322404371584699, 2.8529656160901005, -5.6469140840312235}},
  };
}

class OddSpecifications : public testing::TestWithParam<OddSpecification> {};

TEST_P(OddSpecifications, AreMet) {
  const auto found = find_jets(GetParam().given);

  ASSERT_TRUE(found.jets);
  const std::vector<Point> jets = point_jets(*found.jets, -GetParam().given.at);
  for (std::size_t k = 0; k < jets.size(); ++k) {
    EXPECT_LT(relative(jets[k], {GetParam().x[k], GetParam().y[k]}), 1e-13) << "derivative " << k;
  }
}

TEST_P(OddSpecifications, HaveBothPointsAmongTheirDyads) {
  const auto found = find_jets(GetParam().given);
  ASSERT_TRUE(found.jets);

  const BurmesterSolution solution = solve_burmester(std::vector{*found.jets});

  const auto holds = [&](const Point& fixed) {
    double least = 1e300;
    for (const Dyad& dyad : solution.dyads) {
      least = std::min(least, std::abs(GetParam().given.at + dyad.circle_point - fixed));
    }
    return least;
  };
  EXPECT_LT(holds(GetParam().given.at), 1e-11);
  EXPECT_LT(holds(GetParam().given.curvature->free_point), 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Specification,
                         OddSpecifications,
                         testing::ValuesIn(odd_specifications()),
                         [](const auto& one) { return one.param.name; });

TEST(Specification, SaysThatThePointLiesInThePole) {
  PositionSpecification given = table_5();
  given.at = *given.pole;

  EXPECT_EQ(find_jets(given).fault, SpecificationFault::point_in_pole);
}

TEST(Specification, SaysThatTheFreePointLiesInThePole) {
  PositionSpecification given = table_5();
  given.curvature->free_point = *given.pole;

  EXPECT_EQ(find_jets(given).fault, SpecificationFault::free_point_in_pole);
}

TEST(Specification, SaysThatThePointsAreAligned) {
  PositionSpecification given = table_5();
  given.curvature->free_point = 0.3 * *given.pole;

  EXPECT_EQ(find_jets(given).fault, SpecificationFault::aligned_points);
}

TEST(Specification, SaysThatTheCentreIsOffTheNormal) {
  PositionSpecification given = table_5();
  given.curvature->centre += Point(0.001, 0.0);

  EXPECT_EQ(find_jets(given).fault, SpecificationFault::centre_off_normal);
}

TEST(Specification, SaysThatTheCentreIsThePoint) {
  PositionSpecification given = table_5();
  given.curvature->centre = given.at;

  EXPECT_EQ(find_jets(given).fault, SpecificationFault::centre_in_point);
}

TEST(Specification, SaysThatTheRatioIsZero) {
  PositionSpecification given = table_5();
  given.curvature->ratio = 0.0;

  EXPECT_EQ(find_jets(given).fault, SpecificationFault::zero_ratio);
}

// Both centres in the pole: both points run about it for two instants more, and so does the plane.
TEST(Specification, SaysThatThereIsNoInflectionCircle) {
  PositionSpecification given = table_5();
  given.curvature->centre = *given.pole;
  given.curvature->ratio = 1.0;
  given.is_stationary = true;

  EXPECT_EQ(find_jets(given).fault, SpecificationFault::no_inflection_circle);
}

}  // namespace
}  // namespace kinestat
