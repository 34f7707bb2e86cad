#include "studies/synthesis/linkages/degeneracy.hpp"

#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "studies/synthesis/dyads/burmester.hpp"
#include "studies/synthesis/dyads/few_positions.hpp"

namespace kinestat {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Positions with what follows for them from the places of a parallel plane: all points of it move
/// along the same curve, only shifted.
struct SpecialPositions {
  std::string name;
  std::vector<PositionJets> positions;
  Degeneracy expected = Degeneracy::none;
};

std::vector<SpecialPositions> special_positions() {
  using enum Degeneracy;
  const auto at = [](double x, double y, double angle) { return finite_position({x, y}, angle); };
  const Point c(3.0, -2.0);
  const auto on_circle = [&](double angle) {
    return finite_position(c + 1.5 * unit_vector(angle), 0.4);
  };
  return {
      {.name = "TwoEqual",
       .positions = {at(1, 2, 0.3), at(1, 2, 0.3)},
       .expected = repeated_position},
      {.name = "TwoEqualButForATurn",
       .positions = {at(1, 2, 0.3), at(1, 2, 0.3 + kTurn)},
       .expected = repeated_position},
      {.name = "TwoParallel", .positions = {at(1, 2, 0.3), at(2, 2, 0.3)}, .expected = none},
      {.name = "TwoParallelButForATurn",
       .positions = {at(1, 2, 0.3), at(2, 2, 0.3 - kTurn)},
       .expected = none},
      {.name = "ThreeOfWhichTwoAreEqual",
       .positions = {at(1, 2, 0.3), at(2, 0, 0.9), at(1, 2, 0.3)},
       .expected = repeated_position},
      {.name = "ThreeParallel",
       .positions = {at(1, 2, 0.3), at(2, 2, 0.3), at(3, 5, 0.3 + kTurn)},
       .expected = parallelogram},
      {.name = "ThreeParallelOnALine",
       .positions = {at(1, 2, 0.3), at(2, 4, 0.3), at(3, 6, 0.3)},
       .expected = straight_translation},
      {.name = "ThreeOfWhichTwoAreParallel",
       .positions = {at(1, 2, 0.3), at(2, 2, 0.3), at(3, 5, 0.8)},
       .expected = none},
      {.name = "FourOnACircle",
       .positions = {on_circle(0.3), on_circle(1.0), on_circle(2.0), on_circle(3.5)},
       .expected = parallelogram},
      {.name = "FourOnNoCircle",
       .positions = {on_circle(0.3), on_circle(1.0), on_circle(2.0), at(0, 0, 0.4)},
       .expected = translation},
      {.name = "FourOnALine",
       .positions = {at(0, 1, 0.3), at(1, 2, 0.3), at(2, 3, 0.3), at(5, 6, 0.3)},
       .expected = straight_translation},
      {.name = "FourOfWhichTwoAreEqual",
       .positions = {at(1, 2, 0.3), at(2, 0, 0.9), at(3, 1, 0.1), at(2, 0, 0.9)},
       .expected = repeated_position},
      {.name = "FourOfWhichThreeAreParallel",
       .positions = {at(1, 2, 0.3), at(2, 2, 0.3), at(3, 5, 0.3), at(0, 1, 1.0)},
       .expected = none},
      {.name = "TranslationAlongACircleByDerivatives",
       .positions = {{.x = {1.0, 0.0}, .y = {0.0, 1.0}, .angle = {0.2, 0.0}},
                     {.x = {0.0, -1.0}, .y = {1.0, 0.0}, .angle = {0.2, 0.0}}},
       .expected = parallelogram},
      {.name = "FiveOnNoCircle",
       .positions = {on_circle(0.3), on_circle(1.0), on_circle(2.0), on_circle(3.5), at(0, 0, 0.4)},
       .expected = translation},
  };
}

class Special : public testing::TestWithParam<SpecialPositions> {};

TEST_P(Special, AreRecognised) {
  EXPECT_EQ(find_degeneracy(GetParam().positions), GetParam().expected);
}

TEST_P(Special, LeaveAFamilyOrWhatOthersLeave) {
  const int count = position_count(GetParam().positions);
  const bool is_special = GetParam().expected != Degeneracy::none;
  const BurmesterStatus expected = is_special ? BurmesterStatus::family : BurmesterStatus::solved;

  if (count == 4) {
    const FourPositionCurves found = find_curves(GetParam().positions);
    EXPECT_EQ(found.status, expected);
    EXPECT_EQ(found.reason, GetParam().expected);
  } else if (count == 5) {
    const BurmesterSolution found = solve_burmester(GetParam().positions);
    EXPECT_EQ(found.status, expected);
    EXPECT_EQ(found.reason, GetParam().expected);
  }
}

// Seen from far away, and as large as the sources' drawings.
TEST_P(Special, AreRecognisedElsewhere) {
  std::vector<PositionJets> positions = GetParam().positions;
  for (PositionJets& position : positions) {
    const Point turn = 25.4 * unit_vector(0.7);
    for (std::size_t k = 0; k < position.x.size(); ++k) {
      const Point moved = turn * origin(position, static_cast<int>(k)) +
                          (k == 0 ? Point(1e3, -2e3) : Point(0.0, 0.0));
      position.x[k] = moved.real();
      position.y[k] = moved.imag();
    }
    position.angle[0] += 0.7;
  }

  EXPECT_EQ(find_degeneracy(positions), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(Positions,
                         Special,
                         testing::ValuesIn(special_positions()),
                         [](const auto& one) { return one.param.name; });

// Where three positions are parallel, z + c is the centre of z, and the fourth asks for |E z + D -
// z
// - c| = |c|: a circle.
TEST(ThreeParallelPositions, LeaveACircleOfCirclePointsWithAFourth) {
  const std::vector<PositionJets> positions = {finite_position({1.0, 2.0}, 0.3),
                                               finite_position({2.0, 2.0}, 0.3),
                                               finite_position({3.0, 5.0}, 0.3),
                                               finite_position({0.0, 1.0}, 1.0)};
  const Point arm =
      Point(1.5, 23.0 / 6.0) - Point(1.0, 2.0);  // to the centre of the first three places

  const auto circle = find_curves(positions).circle_points.circle();

  ASSERT_TRUE(circle);
  for (const double angle : {0.1, 2.0, 4.0}) {
    const Point z = circle->centre + circle->radius * unit_vector(angle);
    const Point moving = unit_vector(-0.3) * (z - Point(1.0, 2.0));
    const Point fourth = point_jets(positions[3], moving)[0];
    EXPECT_NEAR(std::abs(fourth - (z + arm)), std::abs(arm), 1e-12);
  }
}

// On a line their points have centres far away, and so must the fourth place lie on that line.
TEST(ThreeParallelPositions, OnALineLeaveALineOfSlidersWithAFourth) {
  const std::vector<PositionJets> positions = {finite_position({1.0, 2.0}, 0.3),
                                               finite_position({2.0, 2.0}, 0.3),
                                               finite_position({4.0, 2.0}, 0.3),
                                               finite_position({0.0, 1.0}, 1.0)};

  const auto line = find_curves(positions).circle_points.line();

  ASSERT_TRUE(line);
  for (const double along : {-1.0, 0.0, 3.0}) {
    const Point z = line->offset * line->normal + along * left_of(line->normal);
    const Point moving = unit_vector(-0.3) * (z - Point(1.0, 2.0));
    EXPECT_NEAR(point_jets(positions[3], moving)[0].imag(), z.imag(), 1e-12);
  }
}

// All points have the same arm to their centre, here from (1, 0) to c.
TEST(Parallelogram, HasTheSameCrankForEveryPoint) {
  const Point c(3.0, -2.0);
  std::vector<PositionJets> positions;
  for (const double angle : {0.0, 1.0, 2.0}) {
    positions.push_back(finite_position(c + 1.5 * unit_vector(angle), 0.4));
  }

  for (const Point& z : {Point(0.0, 0.0), Point(2.0, 5.0), Point(-7.0, 1.0)}) {
    const auto dyad = find_dyad(positions, z);
    ASSERT_TRUE(dyad);
    EXPECT_NEAR(dyad->length, 1.5, 1e-13);
    EXPECT_LT(std::abs(dyad->centre_point - z + Point(1.5, 0.0)), 1e-12);
  }
}

}  // namespace
}  // namespace kinestat
