#include "mechanism/gears/lever_analogy.hpp"

#include <map>

#include <gtest/gtest.h>

#include "support/mechanism_text.hpp"

namespace kinestat {
namespace {

std::vector<Lever> levers_of(const Mechanism& mechanism) {
  return find_levers(mechanism.topology, mechanism.geometry);
}

// The place of each node, with that of `unit` as 1.
std::map<std::string, double> places_of(const Mechanism& mechanism,
                                        const Lever& lever,
                                        const std::string& unit) {
  std::map<std::string, double> places;
  for (const LeverNode& node : lever.nodes) {
    places[mechanism.topology.body(node.body).name] = node.place;
  }
  const double one = places.at(unit);
  for (auto& [name, place] : places) {
    place /= one;
  }
  return places;
}

// Willis: with the carrier at rest the ring turns by -N_sun/N_ring = -2/4 of the sun.
TEST(Lever, OfASimpleSetHasSunCarrierAndRing) {
  const Mechanism mechanism = mechanism_of(R"(
space: planar
ground: housing
bodies: [sun, ring, arm, planet]
couplings:
  a: {type: revolute, bodies: [housing, sun], at: [0, 0]}
  b: {type: revolute, bodies: [housing, arm], at: [0, 0]}
  c: {type: revolute, bodies: [housing, ring], at: [0, 0]}
  d: {type: revolute, bodies: [arm, planet], at: [0, 3]}
  s: {type: gear, bodies: [sun, planet], at: [0, 2], tangent: x, pressure_angle: 20 deg}
  r: {type: gear, bodies: [ring, planet], at: [0, 4], tangent: x, pressure_angle: 20 deg, internal: true}
)");

  const std::vector<Lever> levers = levers_of(mechanism);

  ASSERT_EQ(levers.size(), 1U);
  EXPECT_EQ(mechanism.topology.body(levers.front().carrier).name, "arm");
  const auto places = places_of(mechanism, levers.front(), "sun");
  EXPECT_EQ(places.size(), 3U);
  EXPECT_NEAR(places.at("ring"), -0.5, 1e-15);
  EXPECT_EQ(places.at("arm"), 0.0);
}

// Teeth 19, 41, 85 of suns and ring, 15 of the short, 14 and 22 of the long planet (Cazangi 2008,
// section 5.2): with the carrier at rest ring and second sun turn by 19·22/(14·85) and
// -19·22/(14·41) of the first sun.
TEST(Lever, OfARavigneauxSetHasFourNodes) {
  const Mechanism mechanism = mechanism_of(R"(
space: planar
ground: housing
bodies: [sun1, sun2, ring, carrier, planet5, planet6]
couplings:
  a: {type: revolute, bodies: [housing, sun1], at: [0, 0]}
  b: {type: revolute, bodies: [housing, sun2], at: [0, 0]}
  c: {type: revolute, bodies: [ring, carrier], at: [0, 0]}
  d: {type: revolute, bodies: [housing, ring], at: [0, 0]}
  f: {type: revolute, bodies: [carrier, planet5], at: [0, 17]}
  g: {type: revolute, bodies: [carrier, planet6], at: [0, 31.5]}
  h: {type: gear, bodies: [sun1, planet5], at: [0, 9.5], tangent: x, pressure_angle: 20 deg}
  i: {type: gear, bodies: [planet5, planet6], at: [0, 24.5], tangent: x, pressure_angle: 20 deg}
  j: {type: gear, bodies: [sun2, planet6], at: [0, 20.5], tangent: x, pressure_angle: 20 deg}
  k: {type: gear, bodies: [ring, planet6], at: [0, 42.5], tangent: x, pressure_angle: 20 deg, internal: true}
)");

  const std::vector<Lever> levers = levers_of(mechanism);

  ASSERT_EQ(levers.size(), 1U);
  const auto places = places_of(mechanism, levers.front(), "sun1");
  EXPECT_EQ(places.size(), 4U);
  EXPECT_NEAR(places.at("ring"), 19.0 * 22 / (14 * 85), 1e-14);
  EXPECT_NEAR(places.at("sun2"), -19.0 * 22 / (14 * 41), 1e-14);
  EXPECT_EQ(places.at("carrier"), 0.0);
}

// Left and right turn against each other if the case rests.
TEST(Lever, OfABevelDifferentialHasTheCaseInTheMiddle) {
  const Mechanism mechanism = mechanism_of(R"(
ground: axle
bodies: [case, left, right, pinion]
couplings:
  C: {type: revolute, bodies: [axle, case], at: [-80, 0, 0], axis: x}
  L: {type: revolute, bodies: [axle, left], at: [-120, 0, 0], axis: -x}
  R: {type: revolute, bodies: [axle, right], at: [120, 0, 0], axis: x}
  P: {type: revolute, bodies: [case, pinion], at: [0, 0, 40], axis: z}
  mL: {type: bevel_gear, bodies: [pinion, left], at: [-25, 0, 40], axis: [-25, 0, 40], line_of_action: [0, 1, 0]}
  mR: {type: bevel_gear, bodies: [pinion, right], at: [25, 0, 40], axis: [25, 0, 40], line_of_action: [0, 1, 0]}
)");

  const std::vector<Lever> levers = levers_of(mechanism);

  ASSERT_EQ(levers.size(), 1U);
  const auto places = places_of(mechanism, levers.front(), "left");
  EXPECT_NEAR(places.at("right"), -1.0, 1e-15);
  EXPECT_EQ(places.at("case"), 0.0);
}

TEST(Lever, IsNoneOfGearsWithFixedAxes) {
  EXPECT_TRUE(levers_of(mechanism_of(R"(
space: planar
ground: housing
bodies: [pinion, wheel]
couplings:
  a: {type: revolute, bodies: [housing, pinion], at: [0, 0]}
  b: {type: revolute, bodies: [housing, wheel], at: [3, 0]}
  g: {type: gear, bodies: [pinion, wheel], at: [1, 0], tangent: y, pressure_angle: 20 deg}
)"))
                  .empty());
}

// Both planets turn on one pin, inside one ring; the pin comes first in the file.
TEST(Lever, IsOnTheAxisOfTheTrainWherePlanetsShareAPin) {
  const Mechanism mechanism = mechanism_of(R"(
space: planar
ground: housing
bodies: [sun, other, ring, arm, planet, twin]
couplings:
  d: {type: revolute, bodies: [arm, planet], at: [0, 3]}
  e: {type: revolute, bodies: [arm, twin], at: [0, 3]}
  s: {type: gear, bodies: [planet, sun], at: [0, 2], tangent: x, pressure_angle: 20 deg}
  o: {type: gear, bodies: [twin, other], at: [0, 2], tangent: x, pressure_angle: 20 deg}
  q: {type: gear, bodies: [planet, ring], at: [0, 4], tangent: x, pressure_angle: 20 deg, internal: true}
  r: {type: gear, bodies: [twin, ring], at: [0, 4], tangent: x, pressure_angle: 20 deg, internal: true}
  a: {type: revolute, bodies: [housing, sun], at: [0, 0]}
  c: {type: revolute, bodies: [housing, other], at: [0, 0]}
  f: {type: revolute, bodies: [housing, ring], at: [0, 0]}
  b: {type: revolute, bodies: [housing, arm], at: [0, 0]}
)");

  const std::vector<Lever> levers = levers_of(mechanism);

  ASSERT_EQ(levers.size(), 1U);
  const auto places = places_of(mechanism, levers.front(), "sun");
  EXPECT_EQ(places.size(), 4U);
  EXPECT_NEAR(places.at("other"), 1.0, 1e-15);
  EXPECT_NEAR(places.at("ring"), -0.5, 1e-15);
}

}  // namespace
}  // namespace kinestat
