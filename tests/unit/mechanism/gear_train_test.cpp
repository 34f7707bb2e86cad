#include "mechanism/gears/gear_train.hpp"

#include <gtest/gtest.h>

#include "format/mechanism_reader.hpp"
#include "support/read_text.hpp"

namespace kinestat {
namespace {

// The train points into its description.
struct Found {
  MechanismDescription description;
  GearTrain train;

  int planet_of(const std::string& member) const {
    for (std::size_t i = 0; i < description.gears->members.size(); ++i) {
      if (description.gears->members[i].name.text == member) {
        return train.planet_of[i];
      }
    }
    return -2;
  }
};

Found train_of(const std::string& bodies, const std::string& couplings, const std::string& gears) {
  Diagnostics found;
  const std::string text = "kinestat: 1\nspace: planar\nground: housing\nbodies: " + bodies +
                           "\ncouplings:\n" + couplings + "gears:\n  module: 1\n" + gears;
  const auto root = read_yaml({.path = "test.yaml", .text = text}, ReadLimits{}, found);
  Found result{.description = *read_mechanism(*root, found), .train = {}};
  result.train = find_gear_train(result.description);
  return result;
}

Found ravigneaux(const std::string& side = "") {
  return train_of("[sun1, sun2, ring, carrier, short, long]",
                  "  a: {type: revolute, bodies: [housing, sun1]}\n"
                  "  b: {type: revolute, bodies: [carrier, sun2]}\n"
                  "  B: {type: brake, bodies: [housing, sun2]}\n"
                  "  c: {type: revolute, bodies: [ring, carrier]}\n"
                  "  f: {type: revolute, bodies: [carrier, short]}\n"
                  "  g: {type: revolute, bodies: [carrier, long]}\n",
                  "  members:\n"
                  "    s1: {body: sun1, teeth: 19}\n"
                  "    s2: {body: sun2, teeth: 41}\n"
                  "    p5: {body: short, teeth: 16}\n"
                  "    p6: {body: long, teeth: 22" +
                      side +
                      "}\n"
                      "    r: {body: ring, teeth: 85, internal: true}\n"
                      "  meshes:\n"
                      "    h: {members: [s1, p5], carrier: carrier}\n"
                      "    i: {members: [p5, p6], carrier: carrier}\n"
                      "    j: {members: [s2, p6], carrier: carrier}\n"
                      "    k: {members: [r, p6], carrier: carrier}\n");
}

// A sun may have its bearing on the carrier, if a brake or a shaft holds it too.
TEST(GearTrain, TakesForPlanetsWhatTurnsOnTheCarrierAlone) {
  const Found found = ravigneaux();

  EXPECT_EQ(found.planet_of("s1"), -1);
  EXPECT_EQ(found.planet_of("s2"), -1);
  EXPECT_EQ(found.planet_of("r"), -1);
  EXPECT_EQ(found.planet_of("p5"), 0);
  EXPECT_EQ(found.planet_of("p6"), 1);
}

TEST(GearTrain, PutsAPlanetBesideTheOneBeforeIt) {
  const Found found = ravigneaux(", side: right");

  EXPECT_EQ(found.train.planets[0].neighbour, -1);
  EXPECT_EQ(found.train.planets[1].neighbour, 0);
  EXPECT_EQ(found.train.planets[1].neighbour_mesh, 1);
  EXPECT_EQ(found.train.planets[1].side, PlanetSide::right);
  EXPECT_EQ(found.train.planets[1].on_main, (std::vector<int>{2, 3}));
}

// Sun 1 right, planet 5 left, planet 6 right, sun 2 left, ring right.
TEST(GearTrain, AlternatesHandsOutsideARing) {
  EXPECT_EQ(ravigneaux().train.hand, (std::vector<int>{1, -1, -1, 1}));
}

std::string countershaft(const std::string& of_last) {
  return "  members:\n"
         "    a: {body: in, teeth: 20}\n"
         "    b: {body: counter, teeth: 40}\n"
         "    c: {body: counter, teeth: 25}\n"
         "    d: {body: out, teeth: 35" +
         of_last +
         "}\n"
         "  meshes:\n"
         "    ab: {members: [a, b]}\n"
         "    cd: {members: [c, d]}\n";
}

const std::string kShafts =
    "  i: {type: revolute, bodies: [housing, in]}\n"
    "  l: {type: revolute, bodies: [housing, counter]}\n"
    "  o: {type: revolute, bodies: [housing, out]}\n";

TEST(GearTrain, TakesAShaftBesideTheMainAxisForAPlanet) {
  const Found found = train_of("[in, counter, out]", kShafts, countershaft(""));

  EXPECT_EQ(found.planet_of("a"), -1);
  EXPECT_EQ(found.planet_of("b"), 0);
  EXPECT_EQ(found.planet_of("c"), 0);
  EXPECT_EQ(found.planet_of("d"), -1);
}

TEST(GearTrain, TakesForAPlanetWhatHasACentreDistance) {
  const Found found =
      train_of("[in, counter, out]", kShafts, countershaft(", centre_distance: 50"));

  EXPECT_EQ(found.planet_of("d"), 1);
  EXPECT_EQ(found.train.planets[1].neighbour, 0);
  ASSERT_NE(found.train.planets[1].distance, nullptr);
}

}  // namespace
}  // namespace kinestat
