#include "mechanism/gears/mesh.hpp"

#include <gtest/gtest.h>

#include "support/mechanism_text.hpp"

namespace kinestat {
namespace {

// The carrier of each mesh by name, "-" for none.
std::vector<std::string> carriers_of(const std::string& text) {
  const Mechanism mechanism = mechanism_of(text);
  std::vector<std::string> carriers;
  for (const Mesh& mesh : find_meshes(mechanism.topology, mechanism.geometry)) {
    carriers.push_back(mesh.carrier ? mechanism.topology.body(*mesh.carrier).name : "-");
  }
  return carriers;
}

using Names = std::vector<std::string>;

TEST(Mesh, OfFixedAxesHasTheGroundForCarrier) {
  EXPECT_EQ(carriers_of(R"(
space: planar
ground: housing
bodies: [pinion, wheel]
couplings:
  a: {type: revolute, bodies: [housing, pinion], at: [0, 0]}
  b: {type: revolute, bodies: [housing, wheel], at: [3, 0]}
  g: {type: gear, bodies: [pinion, wheel], at: [1, 0], tangent: y, pressure_angle: 20 deg}
)"),
            Names({"housing"}));
}

// The arm turns on the sun and not on the housing, from which the ring is two hinges away.
TEST(Mesh, OfAPlanetHasTheArmThatSharesBothAxes) {
  EXPECT_EQ(carriers_of(R"(
space: planar
ground: housing
bodies: [sun, ring, arm, planet]
couplings:
  a: {type: revolute, bodies: [housing, sun], at: [0, 0]}
  b: {type: revolute, bodies: [sun, arm], at: [0, 0]}
  c: {type: revolute, bodies: [arm, ring], at: [0, 0]}
  d: {type: revolute, bodies: [arm, planet], at: [0, 3]}
  s: {type: gear, bodies: [sun, planet], at: [0, 2], tangent: x, pressure_angle: 20 deg}
  r: {type: gear, bodies: [ring, planet], at: [0, 4], tangent: x, pressure_angle: 20 deg, internal: true}
)"),
            Names({"arm", "arm"}));
}

// A ring fixed in the housing meets every shaft of a coaxial train there; looking from each mesh at
// all of them again would take minutes.
TEST(Mesh, OfALongCoaxialTrainHasTheArmOfItsPlanet) {
  constexpr int kStages = 2000;
  std::string bodies = "s0";
  std::string couplings = "  a0: {type: revolute, bodies: [g, s0], at: [0, 0]}\n";
  Names arms;
  for (int i = 1; i <= kStages; ++i) {
    const std::string n = std::to_string(i);
    bodies += ", s" + n + ", p" + n;
    couplings += "  a" + n + ": {type: revolute, bodies: [g, s" + n + "], at: [0, 0]}\n";
    couplings += "  b" + n + ": {type: revolute, bodies: [s" + n + ", p" + n + "], at: [0, 3]}\n";
    couplings += "  m" + n + ": {type: gear, bodies: [s" + std::to_string(i - 1) + ", p" + n +
                 "], at: [0, 2], line_of_action: x}\n";
    couplings += "  r" + n + ": {type: gear, bodies: [g, p" + n +
                 "], at: [0, 4], line_of_action: x, internal: true}\n";
    arms.insert(arms.end(), 2, "s" + n);
  }

  EXPECT_EQ(
      carriers_of("space: planar\nground: g\nbodies: [" + bodies + "]\ncouplings:\n" + couplings),
      arms);
}

TEST(Mesh, OfAxesThatNoBodyHasInCommonHasNoCarrier) {
  EXPECT_EQ(carriers_of(R"(
space: planar
ground: housing
bodies: [lever, pinion, wheel]
couplings:
  a: {type: revolute, bodies: [housing, pinion], at: [0, 0]}
  b: {type: revolute, bodies: [housing, lever], at: [3, 3]}
  c: {type: revolute, bodies: [lever, wheel], at: [3, 0]}
  g: {type: gear, bodies: [pinion, wheel], at: [1, 0], tangent: y, pressure_angle: 20 deg}
)"),
            Names({"-"}));
}

// Two bodies on both axes: nobody can say which of them carries the planet.
TEST(Mesh, OfTwoPossibleCarriersHasNone) {
  EXPECT_EQ(carriers_of(R"(
space: planar
ground: housing
bodies: [sun, arm, twin, planet]
couplings:
  a: {type: revolute, bodies: [housing, sun], at: [0, 0]}
  b: {type: revolute, bodies: [housing, arm], at: [0, 0]}
  c: {type: revolute, bodies: [housing, twin], at: [0, 0]}
  d: {type: revolute, bodies: [arm, planet], at: [0, 3]}
  e: {type: revolute, bodies: [twin, planet], at: [0, 3]}
  s: {type: gear, bodies: [sun, planet], at: [0, 2], tangent: x, pressure_angle: 20 deg}
)"),
            Names({"-"}));
}

TEST(Mesh, OfSpatialAxesKnowsLinesFromPoints) {
  EXPECT_EQ(carriers_of(R"(
ground: housing
bodies: [sun, arm, planet]
couplings:
  a: {type: revolute, bodies: [housing, sun], at: [0, 0, -7], axis: z}
  b: {type: cylindrical, bodies: [housing, arm], at: [0, 0, 40], axis: z}
  d: {type: revolute, bodies: [arm, planet], at: [0, 3, 11], axis: [0, 0, -2]}
  s: {type: gear, bodies: [sun, planet], at: [0, 2, 0], axis: z, tangent: x, pressure_angle: 20 deg}
)"),
            Names({"arm"}));
}

}  // namespace
}  // namespace kinestat
