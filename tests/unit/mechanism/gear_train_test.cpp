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

  int axis_of(const std::string& member) const {
    for (std::size_t i = 0; i < description.gears->members.size(); ++i) {
      if (description.gears->members[i].name.text == member) {
        return train.axis_of[i];
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

  EXPECT_EQ(found.axis_of("s1"), -1);
  EXPECT_EQ(found.axis_of("s2"), -1);
  EXPECT_EQ(found.axis_of("r"), -1);
  EXPECT_EQ(found.axis_of("p5"), 0);
  EXPECT_EQ(found.axis_of("p6"), 1);
}

TEST(GearTrain, PutsAPlanetBesideTheOneBeforeIt) {
  const Found found = ravigneaux(", side: right");

  EXPECT_EQ(found.train.axes[0].neighbour, -1);
  EXPECT_EQ(found.train.axes[1].neighbour, 0);
  EXPECT_EQ(found.train.axes[1].neighbour_mesh, 1);
  EXPECT_EQ(found.train.axes[1].side, PlanetSide::right);
  EXPECT_EQ(found.train.axes[1].on_centre, (std::vector<int>{2, 3}));
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

  EXPECT_EQ(found.axis_of("a"), -1);
  EXPECT_EQ(found.axis_of("b"), 0);
  EXPECT_EQ(found.axis_of("c"), 0);
  EXPECT_EQ(found.axis_of("d"), -1);
}

TEST(GearTrain, TakesForAPlanetWhatHasACentreDistance) {
  const Found found =
      train_of("[in, counter, out]", kShafts, countershaft(", centre_distance: 50"));

  EXPECT_EQ(found.axis_of("d"), 1);
  EXPECT_EQ(found.train.axes[1].neighbour, 0);
  ASSERT_NE(found.train.axes[1].distance, nullptr);
}

// What a clutch joins to a lay shaft turns about its axis, wherever it is borne, and so do a shaft
// without gears between two clutches and what turns on that.
TEST(GearTrain, PutsIdlersOnTheAxisOfTheirShaft) {
  const Found found = train_of("[in, out, g1, hub, g2, lay]",
                               "  i: {type: revolute, bodies: [housing, in]}\n"
                               "  l: {type: revolute, bodies: [housing, lay]}\n"
                               "  b: {type: revolute, bodies: [lay, g1]}\n"
                               "  c: {type: revolute, bodies: [lay, g2]}\n"
                               "  S: {type: clutch, bodies: [g1, hub]}\n"
                               "  T: {type: clutch, bodies: [hub, lay]}\n"
                               "  U: {type: clutch, bodies: [lay, g2]}\n",
                               "  members:\n"
                               "    a: {body: in, teeth: 20}\n"
                               "    b: {body: g1, teeth: 40}\n"
                               "    c: {body: in, teeth: 30}\n"
                               "    d: {body: g2, teeth: 30}\n"
                               "    e: {body: lay, teeth: 20}\n"
                               "    f: {body: out, teeth: 40}\n"
                               "  meshes:\n"
                               "    ab: {members: [a, b]}\n"
                               "    cd: {members: [c, d]}\n"
                               "    ef: {members: [e, f]}\n");

  ASSERT_EQ(found.train.axes.size(), 1U);
  EXPECT_EQ(found.train.axes[0].bodies, (std::vector<std::string>{"g1", "g2", "lay", "hub"}));
  EXPECT_EQ(found.train.axes[0].carrier, "housing");
  EXPECT_EQ(found.train.axes[0].on_centre, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(found.train.axis_on("hub"), 0);
  EXPECT_EQ(found.axis_of("f"), -1);
}

TEST(GearTrain, PutsAnAxisThatIsDeclaredBesideTheMainAxis) {
  const Found found =
      train_of("[in, counter, out]",
               kShafts,
               "  axes: {main: {bodies: [in]}, final: {bodies: [out]}}\n" + countershaft(""));

  EXPECT_EQ(found.axis_of("a"), -1);
  EXPECT_EQ(found.axis_of("b"), 0);
  EXPECT_EQ(found.axis_of("d"), 1);
  EXPECT_EQ(found.train.axes[1].neighbour, 0);
  EXPECT_TRUE(found.train.axes[1].is_in_line);
}

// A sun on a shaft beside the main axis, whose carrier and whose ring on the ground follow it.
TEST(GearTrain, FindsPlanetsAboutASecondAxis) {
  const Found found = train_of("[in, sun, carrier, planet]",
                               "  i: {type: revolute, bodies: [housing, in]}\n"
                               "  s: {type: revolute, bodies: [housing, sun]}\n"
                               "  c: {type: revolute, bodies: [housing, carrier]}\n"
                               "  p: {type: revolute, bodies: [carrier, planet]}\n",
                               "  axes: {main: {bodies: [in]}}\n"
                               "  members:\n"
                               "    a: {body: in, teeth: 20}\n"
                               "    b: {body: sun, teeth: 40}\n"
                               "    s: {body: sun, teeth: 20}\n"
                               "    p: {body: planet, teeth: 20}\n"
                               "    r: {body: housing, teeth: 60, internal: true}\n"
                               "  meshes:\n"
                               "    ab: {members: [a, b]}\n"
                               "    sp: {members: [s, p], carrier: carrier}\n"
                               "    rp: {members: [r, p], carrier: carrier}\n");

  EXPECT_EQ(found.axis_of("a"), -1);
  EXPECT_EQ(found.axis_of("b"), 0);
  EXPECT_EQ(found.axis_of("s"), 0);
  EXPECT_EQ(found.axis_of("r"), 0);
  EXPECT_EQ(found.axis_of("p"), 1);
  EXPECT_EQ(found.train.axes[1].about, 0);
  EXPECT_EQ(found.train.axes[1].carrier, "carrier");
  EXPECT_EQ(found.train.axes[1].on_centre, (std::vector<int>{1, 2}));
  EXPECT_EQ(found.train.axis_on("carrier"), 0);
  EXPECT_EQ(found.train.axis_between("carrier", "planet"), 1);
  EXPECT_EQ(found.train.axis_between("planet", "carrier"), 1);
}

}  // namespace
}  // namespace kinestat
