#include "mechanism/gears/gear_layout.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

constexpr double kSameRadius = 1e-12;

// A sun, a ring, and a planet on both, of module 2.
GearTrain plain_train() {
  GearTrain train;
  train.axes = {{.bodies = {"planet"}, .members = {1}, .on_centre = {0, 1}}};
  train.axis_of = {-1, 0, -1};
  train.first = {0, 2};
  train.second = {1, 1};
  train.hand = {1, 1};
  return train;
}

GearNumbers plain_numbers(double sun, double planet, double ring) {
  return {.teeth = {sun, planet, -ring},
          .module = {2.0, 2.0},
          .distance = {std::nullopt},
          .at = {0.0, 5.0}};
}

void expect_point(const Vec3& actual, double x, double y, double z) {
  EXPECT_NEAR(actual.x(), x, kSameRadius);
  EXPECT_NEAR(actual.y(), y, kSameRadius);
  EXPECT_NEAR(actual.z(), z, kSameRadius);
}

TEST(GearLayout, PutsThePlanetOnYAtHalfTheTeethTimesTheModule) {
  const auto layout = find_layout<double>(plain_train(), plain_numbers(24, 18, 60));

  expect_point(layout->centres[0], 0.0, 42.0, 0.0);
  expect_point(layout->meshes[0].pitch_point, 0.0, 24.0, 0.0);
  expect_point(layout->meshes[1].pitch_point, 0.0, 60.0, 5.0);
  expect_point(layout->meshes[0].tangent, 1.0, 0.0, 0.0);
}

// The third Prius: 30 + 23 = 53 and 78 - 23 = 55 teeth; 54 in the mean, which 30 : 23 and 78 : 23
// divide.
TEST(GearLayout, DividesTheMeanDistanceInTheRatioOfTeeth) {
  const auto layout = find_layout<double>(plain_train(), plain_numbers(30, 23, 78));

  EXPECT_NEAR(*layout->meshes[0].asked, 53.0, kSameRadius);
  EXPECT_NEAR(*layout->meshes[1].asked, 55.0, kSameRadius);
  EXPECT_NEAR(layout->meshes[0].distance, 54.0, kSameRadius);
  expect_point(layout->meshes[0].pitch_point, 0.0, 54.0 * 30 / 53, 0.0);
  expect_point(layout->meshes[1].pitch_point, 0.0, 54.0 * 78 / 55, 5.0);
}

TEST(GearLayout, TakesTheDistanceThatIsGiven) {
  GearNumbers numbers = plain_numbers(30, 23, 78);
  numbers.distance[0] = 54.5;
  const auto layout = find_layout<double>(plain_train(), numbers);

  expect_point(layout->centres[0], 0.0, 54.5, 0.0);
}

TEST(GearLayout, HasNoneWithoutModuleAndDistance) {
  GearNumbers numbers = plain_numbers(30, 23, 78);
  numbers.module = {std::nullopt, std::nullopt};

  EXPECT_FALSE(find_layout<double>(plain_train(), numbers).has_value());
}

// Two planets, at 30 and at 40 from the main axis, of module 2 in a mesh of `teeth` in all.
std::optional<GearLayout> paired(PlanetSide side, double teeth) {
  GearTrain train;
  train.axes = {{.bodies = {"a"}, .members = {0}, .on_centre = {}},
                {.bodies = {"b"},
                 .members = {1},
                 .on_centre = {},
                 .neighbour = 0,
                 .neighbour_mesh = 0,
                 .side = side}};
  train.axis_of = {0, 1};
  train.first = {0};
  train.second = {1};
  train.hand = {1};
  return find_layout<double>(
      std::move(train),
      {.teeth = {20.0, teeth - 20.0}, .module = {2.0}, .distance = {30.0, 40.0}, .at = {0.0}});
}

// The right angle of the triangle 30, 40, 50 is at the main axis.
TEST(GearLayout, PutsTheNeighbourByTheTriangleToTheLeft) {
  expect_point(paired(PlanetSide::left, 50)->centres[1], -40.0, 0.0, 0.0);
  expect_point(paired(PlanetSide::right, 50)->centres[1], 40.0, 0.0, 0.0);
}

// Beyond its neighbour at 30, half of 50 teeth of module 2 farther.
TEST(GearLayout, PutsInLineWhatNothingGivesADistance) {
  GearTrain train;
  train.axes = {
      {.bodies = {"a"}, .members = {0}},
      {.bodies = {"b"}, .members = {1}, .neighbour = 0, .neighbour_mesh = 0, .is_in_line = true}};
  train.axis_of = {0, 1};
  train.first = {0};
  train.second = {1};
  const auto layout = find_layout<double>(
      std::move(train),
      {.teeth = {20.0, 30.0}, .module = {2.0}, .distance = {30.0, std::nullopt}, .at = {0.0}});

  expect_point(layout->centres[1], 0.0, 80.0, 0.0);
  expect_point(layout->meshes[0].pitch_point, 0.0, 50.0, 0.0);
}

// A planet 12 from a shaft that stands 30 from the main axis.
TEST(GearLayout, PutsAPlanetBesideTheAxisOfItsCarrier) {
  GearTrain train;
  train.axes = {{.bodies = {"shaft"}, .members = {0}},
                {.bodies = {"planet"}, .members = {1}, .about = 0, .on_centre = {0}}};
  train.axis_of = {0, 1};
  train.first = {0};
  train.second = {1};
  const auto layout = find_layout<double>(
      std::move(train),
      {.teeth = {8.0, 4.0}, .module = {2.0}, .distance = {30.0, std::nullopt}, .at = {0.0}});

  expect_point(layout->centres[1], 0.0, 42.0, 0.0);
  expect_point(layout->meshes[0].pitch_point, 0.0, 38.0, 0.0);
}

// On the way from (0, 30) to (-40, 0), after 20 of 50 teeth.
TEST(GearLayout, FindsThePitchPointBetweenTwoPlanets) {
  expect_point(paired(PlanetSide::left, 50)->meshes[0].pitch_point, -16.0, 18.0, 0.0);
}

TEST(GearLayout, PutsPlanetsInLineWhereTheTriangleDoesNotClose) {
  expect_point(paired(PlanetSide::left, 10)->centres[1], 0.0, 40.0, 0.0);
  expect_point(paired(PlanetSide::left, 8)->centres[1], 0.0, 40.0, 0.0);
  expect_point(paired(PlanetSide::left, 70)->centres[1], 0.0, -40.0, 0.0);
  expect_point(paired(PlanetSide::left, 90)->centres[1], 0.0, -40.0, 0.0);
}

// The planet at +y, of module m: y = (z_s + z_p + z_r - z_p) m/4; dy/dz_s = m/4, dy/dz_p = 0.
TEST(GearLayout, HasDerivativesTowardsNumbersOfTeeth) {
  GearNumbersOf<Dual> numbers;
  numbers.teeth = {make_variable(24.0, 0, 2), make_variable(18.0, 1, 2), Dual(-60.0)};
  numbers.module = {Dual(2.0), Dual(2.0)};
  numbers.distance = {std::nullopt};
  numbers.at = {Dual(0.0), Dual(0.0)};
  const auto layout = find_layout<Dual>(plain_train(), numbers);

  EXPECT_NEAR(derivative(layout->centres[0][1], 0), 0.5, kSameRadius);
  EXPECT_NEAR(derivative(layout->centres[0][1], 1), 0.0, kSameRadius);
}

}  // namespace
}  // namespace kinestat
