#include "studies/synthesis/dyads/few_positions.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "known_linkage.hpp"
#include "near_dyad.hpp"
#include "studies/synthesis/curves/cubic_branches.hpp"
#include "studies/synthesis/positions/specification.hpp"

namespace kinestat {
namespace {

/// A crank-rocker in four positions; computed in arithmetic of 60 digits, independently of this
/// library. Fixed frame, at the first position.
struct ReferenceCurves {
  std::string name;
  std::vector<PositionJets> positions;
  Point circle_focus;
  Point centre_focus;
  std::vector<double> circle_asymptote;  ///< a x + b y + c = 0
  std::vector<double> centre_asymptote;
  std::vector<Point> circle_points;
  std::vector<Point> centres;  ///< of those circle points
};

const std::vector<ReferenceCurves>& reference_curves() {
  static const std::vector<ReferenceCurves> kCurves = {
      {.name = "FP1",
       .positions =
           {{.x = {0.581552593014371}, .y = {0.38368212248895894}, .angle = {0.4721943757718849}},
            {.x = {0.15706132828548014}, .y = {0.977349558587791}, .angle = {0.274116014223641}},
            {.x = {-0.6698577952420949}, .y = {1.0897675153749908}, .angle = {0.15870431586504097}},
            {.x = {-1.28529867753234},
             .y = {-0.23927553986552447},
             .angle = {0.29903554959787193}}},
       .circle_focus = {1.9601985898797316, 4.981347079836058},
       .centre_focus = {2.00035819409791, 5.00986854669409},
       .circle_asymptote = {0.011622511418533148, 0.012473080905292599, -0.09533306782514503},
       .centre_asymptote = {0.01785012379922791, 0.013337092365218146, -0.0935600319298856},
       .circle_points = {{2.3328183496591595, 0.5336020236909395},
                         {-3.278992006453308, 5.762729489294409},
                         {3.0024762989439644, 0.9347434502212705},
                         {-3.1295520651260076, 6.648614002438338},
                         {3.4298772951738834, 1.5616217435672988},
                         {-2.882439323165585, 7.443486258926665},
                         {3.4319221569225538, 2.584850110122082},
                         {-2.5935692939795407, 8.199448758373263}},
       .centres = {{1.5767950287226304, -0.2875846742467894},
                   {-3.7688540958875185, 6.866935670110497},
                   {2.4658594246639827, -0.22316359669603295},
                   {-3.636284490295749, 7.943835726694712},
                   {3.2415352771460992, -0.006985338289284859},
                   {-3.5597517286238984, 9.095734484187467},
                   {3.888825208975604, 0.38102232003250974},
                   {-3.9703224769043337, 10.899563791277531}}},
      {.name = "FP2",
       .positions = {{.x = {0.581552593014371, 0.9832693066120518},
                      .y = {0.38368212248895894, -3.174115591931882},
                      .angle = {0.4721943757718849, 1.0}},
                     {.x = {-0.6698577952420949, 17.177741252765124},
                      .y = {1.0897675153749908, 5.978971650557768},
                      .angle = {0.15870431586504097, 1.0}}},
       .circle_focus = {3.615217429098353, 0.334153677713924},
       .centre_focus = {4.034696811346222, 0.32635758625158395},
       .circle_asymptote = {0.01148758275214329, 0.018477214340658087, -0.17613686126935382},
       .centre_asymptote = {0.022742830497225166, 0.01614788074990575, -0.15422583662432907},
       .circle_points = {{2.2023549044431077, -0.5537126125075187},
                         {1.0648177312042082, 0.1535126309896348},
                         {3.176901015854159, -0.27647080187717654},
                         {0.6140406414311367, 1.316900909387219},
                         {3.615217429098353, 0.3341536777139239},
                         {0.6313367768681883, 2.1892804994874533},
                         {3.762898371295273, 1.1254709263993943},
                         {0.8413522204386241, 2.941843381327366}},
       .centres = {{1.175483372561674, -1.8234340855623823},
                   {0.08540297610203483, -0.2881543749307392},
                   {2.4643828999734794, -2.299681816852137},
                   {-0.09544036828578294, 1.3055978848333707},
                   {3.282453501156543, -2.112809561794872},
                   {0.1351546173957529, 2.3198764448747906},
                   {3.843418872682629, -1.563827829425983},
                   {0.521619364347306, 3.1146265345794664}}},
      {.name = "FP4",
       .positions =
           {{.x = {0.581552593014371, 0.9832693066120518, -8.583284561307499, 19.70585554927204},
             .y = {0.38368212248895894,
                   -3.174115591931882,
                   -1.7316554608853492,
                   -15.027507093722452},
             .angle = {0.4721943757718849, 1.0, 0.0, 0.0}}},
       .circle_focus = {-1.034505439558702, -7.7628501424905645},
       .centre_focus = {11.070148056542244, -1.686008059553551},
       .circle_asymptote = {0.00986973173458513, 0.01343090839715293, -0.22532609412532728},
       .centre_asymptote = {0.010989627791638742, -0.009668318979780325, 0.08184312443188918},
       .circle_points = {{-1.0345054395587021, -7.7628501424905645},
                         {-2.2805255828141666, -6.847209577744574},
                         {0.3661750530104399, -7.861415356345635},
                         {-2.8405565489702265, -5.504941786540436},
                         {1.2370968516423555, -7.570686261981542},
                         {-2.8746083412908314, -4.549190915132661},
                         {1.9172124375978148, -7.139742814520675},
                         {-2.7221023108094293, -3.730532458444532}},
       .centres = {{19.177634810589367, 30.760352623484728},
                   {56.682669070794134, 73.39096583497336},
                   {10.685736530612166, 20.235026994574554},
                   {-112.09441865322356, -119.32472568754645},
                   {7.9504860574483285, 16.253074299132667},
                   {-37.648556426909515, -35.57770472317888},
                   {6.404382340897183, 13.622781625679927},
                   {-22.67831163922353, -19.43446262619737}}},
  };
  return kCurves;
}

double distance(const PlaneLine& line, const std::vector<double>& expected) {
  const Point normal(expected[0], expected[1]);
  const double turned = std::abs(cross(line.normal, normal)) / std::abs(normal);
  const Point foot = line.offset * line.normal;
  return turned + std::abs(dot(normal, foot) + expected[2]) / std::abs(normal);
}

class Curves : public testing::TestWithParam<ReferenceCurves> {};

TEST_P(Curves, HaveTheirFoci) {
  const FourPositionCurves found = find_curves(GetParam().positions);

  EXPECT_EQ(found.status, BurmesterStatus::solved);
  EXPECT_LT(relative(*found.circle_points.focus(), GetParam().circle_focus), 1e-12);
  EXPECT_LT(relative(*found.centre_points.focus(), GetParam().centre_focus), 1e-12);
}

TEST_P(Curves, HaveTheirAsymptotes) {
  const FourPositionCurves found = find_curves(GetParam().positions);

  EXPECT_LT(distance(*found.circle_points.asymptote(), GetParam().circle_asymptote), 1e-11);
  EXPECT_LT(distance(*found.centre_points.asymptote(), GetParam().centre_asymptote), 1e-11);
}

TEST_P(Curves, HoldTheirPoints) {
  const FourPositionCurves found = find_curves(GetParam().positions);

  for (std::size_t i = 0; i < GetParam().circle_points.size(); ++i) {
    EXPECT_LT(found.circle_points.miss(GetParam().circle_points[i]), 1e-12);
    EXPECT_LT(found.centre_points.miss(GetParam().centres[i]), 1e-12);
    const auto dyad = find_dyad(GetParam().positions, GetParam().circle_points[i]);
    ASSERT_TRUE(dyad);
    EXPECT_LT(relative(dyad->centre_point, GetParam().centres[i]), 1e-10);
  }
}

TEST_P(Curves, AreSampledOnBothOfThem) {
  const FourPositionCurves found = find_curves(GetParam().positions);

  std::size_t count = 0;
  for (const CurveBranch& branch : sample(found.circle_points, {0.0, 0.0}, 20.0, 400)) {
    for (const Point& point : branch.points) {
      ++count;
      EXPECT_LT(found.circle_points.miss(point), 1e-10);
      const auto dyad = find_dyad(GetParam().positions, point);
      ASSERT_TRUE(dyad);
      // In a pole circle point and centre coincide, and the length has no digits.
      if (dyad->kind == DyadKind::crank && dyad->length > 1e-2) {
        EXPECT_LT(dyad->residual, 1e-8);
        EXPECT_LT(found.centre_points.miss(dyad->centre_point), 1e-8);
      }
    }
  }
  EXPECT_GT(count, 200U);
}

INSTANTIATE_TEST_SUITE_P(FourPositions,
                         Curves,
                         testing::ValuesIn(reference_curves()),
                         [](const auto& one) { return one.param.name; });

struct CurveForm {
  std::string name;
  std::vector<int> orders;
};

class KnownCurves : public testing::TestWithParam<CurveForm> {};

TEST_P(KnownCurves, HoldTheDyadsOfALinkage) {
  Random random(4);
  int done = 0;
  for (int seed = 0; done < 60; ++seed) {
    SCOPED_TRACE(seed);
    const KnownLinkage linkage = random_linkage(
        random, DyadKind::crank, seed % 2 == 0 ? DyadKind::slider : DyadKind::inverted_slider);
    const auto positions = random_positions(random, linkage, GetParam().orders);
    if (positions.empty()) {
      continue;
    }
    ++done;
    const Point circle_point = point_jets(positions[0], linkage.one.circle_point)[0];

    const FourPositionCurves found = find_curves(positions);

    EXPECT_LT(found.circle_points.miss(circle_point), 1e-10);
    EXPECT_LT(found.centre_points.miss(linkage.one.centre_point), 1e-10);
    const auto dyad = find_dyad(positions, circle_point);
    ASSERT_TRUE(dyad);
    EXPECT_LT(kinestat::distance(*dyad, linkage.one), 1e-8);
    const auto& infinite = seed % 2 == 0 ? found.slider : found.inverted_slider;
    ASSERT_TRUE(infinite);
    EXPECT_LT(kinestat::distance(*infinite, linkage.other), 1e-8);
  }
}

INSTANTIATE_TEST_SUITE_P(FourPositions,
                         KnownCurves,
                         testing::Values(CurveForm{"PPPP", {4}},
                                         CurveForm{"PPPandP", {3, 1}},
                                         CurveForm{"PPandPP", {2, 2}},
                                         CurveForm{"PPandPandP", {2, 1, 1}},
                                         CurveForm{"Finite", {1, 1, 1, 1}}),
                         [](const auto& one) { return one.param.name; });

// Three places of a point and the centre of the circle through them.
TEST(ThreePositions, GiveEachPointTheCentreOfItsCircle) {
  const std::vector<PositionJets> positions = {finite_position({0.0, 0.0}, 0.0),
                                               finite_position({1.0, 0.5}, 0.7),
                                               finite_position({0.5, 2.0}, -0.4)};

  const auto dyad = find_dyad(positions, {0.8, -0.3});

  ASSERT_TRUE(dyad);
  for (const PositionJets& position : positions) {
    const Point place = point_jets(position, {0.8, -0.3})[0];
    EXPECT_NEAR(std::abs(place - dyad->centre_point), dyad->length, 1e-13 * dyad->length);
  }
}

// The plane turns about a fixed point, which is the centre of all its points.
TEST(ThreePositions, TellACentreBesideTheOriginFromOneInIt) {
  const auto centre_of = [](double x) {
    std::vector<PositionJets> positions;
    for (const double angle : {0.0, 1.0, 2.5}) {
      positions.push_back(finite_position(Point(x, 0.0) + 2.0 * unit_vector(angle + 0.3), angle));
    }
    return find_dyad(positions, {1.2, 1.7})->centre_point;
  };

  EXPECT_EQ(centre_of(0.0), Point(0.0, 0.0));
  EXPECT_NEAR(centre_of(1e-13).real(), 1e-13, 2e-15);
  EXPECT_EQ(centre_of(1e-13).imag(), 0.0);
}

TEST(ThreePositions, OfTheSamePlaneHaveTheInflectionCircle) {
  const auto position =
      find_jets({.at = {0.0, 0.0},
                 .angle = 0.5,
                 .pole = Point(3.75, 3.25),
                 .curvature = CurvatureSpecification{{3.0, 2.6}, {0.75, 2.0}, 0.58}});
  const Circle expected = inflection_circle(*find_special_frame(*position.jets));

  const auto found = find_straight_path_circle(std::vector{*position.jets});

  ASSERT_TRUE(found);
  EXPECT_LT(std::abs(found->centre - expected.centre), 1e-13);
  EXPECT_NEAR(found->radius, expected.radius, 1e-13);
}

TEST(ThreePositions, LeadThePointsOfACircleOnLines) {
  const std::vector<PositionJets> positions = {finite_position({0.0, 0.0}, 0.0),
                                               finite_position({1.0, 0.5}, 0.7),
                                               finite_position({0.5, 2.0}, -0.4)};
  const auto circle = find_straight_path_circle(positions);
  ASSERT_TRUE(circle);
  const Point moving = circle->centre + circle->radius * unit_vector(1.234);

  const Point a = point_jets(positions[0], moving)[0];
  const Point b = point_jets(positions[1], moving)[0];
  const Point c = point_jets(positions[2], moving)[0];

  EXPECT_NEAR(cross(b - a, c - a) / std::abs(b - a) / std::abs(c - a), 0.0, 1e-13);
  const auto dyad = find_dyad(positions, moving);
  ASSERT_TRUE(dyad);
  EXPECT_EQ(dyad->kind, DyadKind::slider);
}

}  // namespace
}  // namespace kinestat
