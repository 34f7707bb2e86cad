#include "studies/synthesis/positions/special_frame.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "near_dyad.hpp"
#include "studies/synthesis/positions/path_curvature.hpp"

namespace kinestat {
namespace {

// do Valle 1983, table 5, read as five coincident positions with the corrected eq. 2.53; 60 digits.
const PositionJets kTable5 = {
    .x = {0.0, 3.25, 7.140219242230737, 13.712629083352226, 79.15353201470413},
    .y = {0.0, -3.75, 1.2324393358876118, 5.620887628060526, 5.382761},
    .angle = {0.0, 1.0, 0.0, 0.0, 0.0}};

PositionJets table_5(int order) {
  PositionJets jets = kTable5;
  jets.x.resize(static_cast<std::size_t>(order));
  jets.y.resize(static_cast<std::size_t>(order));
  jets.angle.resize(static_cast<std::size_t>(order));
  return jets;
}

TEST(SpecialFrame, OfTable5IsTheOneOfTheSource) {
  const auto frame = find_special_frame(table_5(4));

  ASSERT_TRUE(frame);
  EXPECT_LT(std::abs(frame->pole - Point(3.75, 3.25)), 1e-14);
  EXPECT_NEAR(frame->diameter, 3.945141004294418, 1e-14);
  EXPECT_NEAR(frame->angle, -2.107614068818801, 1e-14);
  EXPECT_LT(std::abs(frame->derivatives[3] - Point(-10.282484806257916, 13.619893984363163)),
            1e-13);
}

TEST(SpecialFrame, OfTable5HasItsStationaryCurvature) {
  const auto cubic = find_stationary_curvature(*find_special_frame(table_5(4)));

  ASSERT_TRUE(cubic);
  EXPECT_NEAR(1.0 / cubic->inverse_m, 30.067141391776246, 1e-11);
  EXPECT_NEAR(1.0 / cubic->inverse_n, 3.4282508134720073, 1e-13);
}

TEST(SpecialFrame, OfTable5HasItsBallPoint) {
  const auto ball = find_ball_point(*find_special_frame(table_5(4)));

  ASSERT_TRUE(ball);
  EXPECT_LT(std::abs(*ball - Point(4.010597772544078, 0.8872587592577862)), 1e-13);
}

TEST(SpecialFrame, LeadsBackToThePosition) {
  const PositionJets given = table_5(5);

  const PositionJets back = jets_of(*find_special_frame(given), {0.0, 0.0}, 0.0);

  for (int k = 0; k < 5; ++k) {
    EXPECT_LT(relative(origin(back, k), origin(given, k)), 1e-14) << "derivative " << k;
  }
}

TEST(SpecialFrame, HasTheInflectionCircleBetweenPoleAndInflectionPole) {
  const Circle circle = inflection_circle(*find_special_frame(table_5(3)));

  EXPECT_LT(std::abs(circle.centre - Point(5.4451096211153684, 2.2412196679438057)), 1e-14);
}

// The same motion by another parameter t with γ = t + t²/3: nothing of the frame changes.
TEST(SpecialFrame, DoesNotDependOnTheParameter) {
  const auto reference = find_special_frame(table_5(4));
  PositionJets other = table_5(4);
  const double second = 2.0 / 3.0;
  other.angle = {0.0, 1.0, second, 0.0};
  for (std::vector<double>* f : {&other.x, &other.y}) {
    // f'(γ(t)): f_t = f1 γ', f_tt = f2 γ'² + f1 γ'', f_ttt = f3 γ'³ + 3 f2 γ' γ''.
    (*f)[3] += 3.0 * (*f)[2] * second;
    (*f)[2] += (*f)[1] * second;
  }

  const auto found = find_special_frame(other);

  ASSERT_TRUE(found);
  EXPECT_LT(std::abs(found->pole - reference->pole), 1e-14);
  EXPECT_NEAR(found->angle, reference->angle, 1e-14);
  EXPECT_LT(std::abs(found->derivatives[3] - reference->derivatives[3]), 1e-13);
}

// P = o + i o'/γ'. 0.3 - (0.1 + 0.2) is rounding of its terms; 1e-13 is a place.
TEST(SpecialFrame, HasAZeroInItsPoleOnlyWhereRoundingLeavesIt) {
  const PositionJets jets = {.x = {0.3, 3.0}, .y = {0.0, 0.1 + 0.2}, .angle = {0.0, 1.0}};
  PositionJets beside = jets;
  beside.x[0] = 1e-13;
  beside.y[1] = 0.0;

  EXPECT_EQ(find_pole(jets), Point(0.0, 3.0));
  EXPECT_EQ(find_pole(beside), Point(1e-13, 3.0));
}

// A wheel of radius 2 rolls on a line. Its point of contact, E, has o' = 0, o'' = 2i and o''' = -2
// in the frame of the line, so that α3 = -2, β3 = 0, and by 3 d²/M - 3 d = -2 M is 3.
TEST(SpecialFrame, OfARollingWheelIsEvenHoweverTheLineIsTurned) {
  PositionJets jets{
      .x = {0.3, 0.0, 0.0, -2.0}, .y = {0.4, 0.0, 2.0, 0.0}, .angle = {0.0, 1.0, 0.0, 0.0}};
  for (std::size_t k = 1; k < 4; ++k) {
    const Point jet = unit_vector(0.7) * Point(jets.x[k], jets.y[k]);
    jets.x[k] = jet.real();
    jets.y[k] = jet.imag();
  }

  const auto frame = find_special_frame(jets);
  ASSERT_TRUE(frame);
  const auto cubic = find_stationary_curvature(*frame);

  EXPECT_NEAR(frame->diameter, 2.0, 1e-15);
  ASSERT_TRUE(cubic);
  EXPECT_NEAR(cubic->inverse_m, 1.0 / 3.0, 1e-15);
  EXPECT_EQ(cubic->inverse_n, 0.0);
}

TEST(SpecialFrame, NeedsATurn) {
  PositionJets jets = table_5(3);
  jets.angle[1] = 0.0;

  EXPECT_FALSE(find_special_frame(jets));
}

// The pole is at o + i o'/γ', the diameter of the inflection circle grows with 1/γ'^3.
TEST(SpecialFrame, EndsWhereLengthsCannotBeComputedWith) {
  const auto with_turn = [](double turn) {
    return PositionJets{.x = {0.0, 1.0, 0.0}, .y = {0.0, 0.0, 1.0}, .angle = {0.0, turn, 1.0}};
  };

  EXPECT_EQ(find_pole(with_turn(1e-10)), Point(0.0, 1e10));
  EXPECT_TRUE(find_special_frame(with_turn(1e-10)));
  EXPECT_TRUE(find_pole(with_turn(1e-50)));
  EXPECT_FALSE(find_special_frame(with_turn(1e-50)));
  EXPECT_FALSE(find_pole(with_turn(1e-62)));
  EXPECT_FALSE(find_pole(with_turn(1e-310)));
}

// Z' = 1 and Z'' = i: K' = Z' x Z'''.
TEST(PathCurvature, ChangesByLittleOrNotAtAll) {
  const PositionJets little = {
      .x = {0.0, 1.0, 0.0, 0.0}, .y = {0.0, 0.0, 1.0, 1e-13}, .angle = {0.0, 1.0, 0.0, 0.0}};
  PositionJets turned = little;
  turned.y[3] = 0.0;
  for (std::size_t k = 1; k < 4; ++k) {
    const Point jet = unit_vector(0.7) * Point(turned.x[k], turned.y[k]);
    turned.x[k] = jet.real();
    turned.y[k] = jet.imag();
  }

  const PathCurvature found = find_path_curvature(little, {0.0, 0.0});
  const PathCurvature even = find_path_curvature(turned, {0.0, 0.0});

  EXPECT_DOUBLE_EQ(found.k_prime.value(), 1e-13);
  EXPECT_NEAR(even.k.value(), 1.0, 1e-15);
  EXPECT_EQ(even.k_prime, 0.0);
}

TEST(PathCurvature, OfBallsPointAndItsDerivativeVanish) {
  const PositionJets jets = table_5(4);
  const Point ball = *find_ball_point(*find_special_frame(jets));

  const PathCurvature found = find_path_curvature(jets, ball);

  ASSERT_TRUE(found.k_prime);
  EXPECT_NEAR(*found.k, 0.0, 1e-14);
  EXPECT_NEAR(*found.k_prime, 0.0, 1e-13);
  EXPECT_FALSE(found.k_second);
}

// The origin of table 5 runs about (3, 2.6) for all five instants.
TEST(PathCurvature, OfABurmesterPointIsThatOfItsCircle) {
  const PathCurvature found = find_path_curvature(kTable5, {0.0, 0.0});

  EXPECT_NEAR(std::abs(*found.k), 1.0 / std::hypot(3.0, 2.6), 1e-14);
  EXPECT_NEAR(*found.k_prime, 0.0, 1e-14);
}

// A point at a distance r from the centre of a plane that turns, with the parabola of its moving
// centre: x = t, y = t²: K = 2 / (1 + 4 t²)^(3/2) has K = 2, K' = 0, K'' = -24 at t = 0.
TEST(PathCurvature, OfAParabolaIsKnown) {
  const PositionJets parabola{.x = {0.0, 1.0, 0.0, 0.0, 0.0},
                              .y = {0.0, 0.0, 2.0, 0.0, 0.0},
                              .angle = {0.3, 1.0, 0.0, 0.0, 0.0}};

  const PathCurvature found = find_path_curvature(parabola, {0.0, 0.0});

  EXPECT_NEAR(*found.k, 2.0, 1e-15);
  EXPECT_NEAR(*found.k_prime, 0.0, 1e-15);
  EXPECT_NEAR(*found.k_second, -24.0, 1e-13);
}

TEST(PathCurvature, IsOpenAtACusp) {
  const PositionJets jets = table_5(4);

  EXPECT_FALSE(find_path_curvature(jets, {3.75, 3.25}).k);
}

}  // namespace
}  // namespace kinestat
