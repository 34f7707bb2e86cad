#include "mechanism/gears/internal/gear_check.hpp"

#include <gtest/gtest.h>

#include "unit/mechanism/checked_text.hpp"

namespace kinestat {
namespace {

// A sun and a planet, whose lines are 32 and 33.
std::string train(const std::string& sun, const std::string& planet, const std::string& rest = "") {
  return "gears: {module: 2, members: {\n\n  sun: {body: sun, " + sun +
         "},\n  planet: {body: planet, " + planet + "}},\n" +
         (rest.empty() ? "  meshes: {h: {members: [sun, planet], carrier: carrier}}}\n" : rest);
}

TEST(GearCheck, AcceptsATrain) {
  EXPECT_EQ(
      complaints_about("gears:\n"
                       "  module: 2\n"
                       "  pressure_angle: alpha\n"
                       "  helix_angle: -15\n"
                       "  members:\n"
                       "    sun: {body: sun, teeth: N1}\n"
                       "    planet: {body: planet, teeth: N2, count: 4, centre_distance: 34}\n"
                       "    ring: {body: ring, teeth: N1 + 2*N2, internal: true}\n"
                       "  meshes:\n"
                       "    h: {members: [sun, planet], carrier: carrier, at: 10}\n"
                       "    k: {members: [ring, planet], carrier: carrier, module: 2,\n"
                       "        pressure_angle: 14.5, helix_angle: 0}\n"),
      Complaints{});
}

TEST(GearCheck, RefusesAFractionOfATooth) {
  EXPECT_EQ(
      complaints_about(train("teeth: 20.5", "teeth: (N1 + 2)/2")),
      (Complaints{"32:27 E0305 'teeth' of gear member 'sun' cannot be 20.5",
                  "33:33 E0305 'teeth' of gear member 'planet' cannot be (N1 + 2)/2 = 10.5"}));
}

TEST(GearCheck, RefusesNoTeethAndTooMany) {
  EXPECT_EQ(complaints_about(train("teeth: 0", "teeth: -3")),
            (Complaints{"32:27 E0305 'teeth' of gear member 'sun' cannot be 0",
                        "33:33 E0305 'teeth' of gear member 'planet' cannot be -3"}));
  EXPECT_EQ(complaints_about(train("teeth: 1e9", "teeth: 10001")),
            (Complaints{"32:27 E0305 'teeth' of gear member 'sun' cannot be 1e9",
                        "33:33 E0305 'teeth' of gear member 'planet' cannot be 10001"}));
}

TEST(GearCheck, AcceptsOneToothAndTenThousand) {
  EXPECT_EQ(complaints_about(train("teeth: 1", "teeth: 10000")), Complaints{});
}

TEST(GearCheck, RefusesTeethWithAUnit) {
  EXPECT_EQ(complaints_about(train("teeth: 9 mm", "teeth: 9")),
            (Complaints{"32:27 E0309 expected a bare number, found a length"}));
}

TEST(GearCheck, WantsWholeCountsAndDistancesAboveZero) {
  EXPECT_EQ(
      complaints_about(train("teeth: 9, count: 65", "teeth: 9, count: 0.5, centre_distance: 0")),
      (Complaints{"32:37 E0305 'count' of gear member 'sun' cannot be 65",
                  "33:43 E0305 'count' of gear member 'planet' cannot be 0.5",
                  "33:65 E0305 'centre_distance' of gear member 'planet' cannot be 0"}));
}

TEST(GearCheck, WantsALoadThatPlanetsCanShare) {
  EXPECT_EQ(complaints_about(train("teeth: 9", "teeth: 9, count: 3, load_sharing: 3.5")),
            (Complaints{"33:60 E0314 'load_sharing' of gear member 'planet' is 3.5, and of 3 "
                        "planets one cannot bear more than 3 times the mean"}));
}

TEST(GearCheck, WantsAToothFormThatCanBe) {
  EXPECT_EQ(
      complaints_about("gears:\n"
                       "  module: -2\n"
                       "  pressure_angle: 90\n"
                       "  helix_angle: -1.6 rad\n"
                       "  members: {sun: {body: sun, teeth: 9}, p: {body: planet, teeth: 9}}\n"
                       "  meshes:\n"
                       "    h: {members: [sun, p], module: 0, pressure_angle: -1, at: 1 N}\n"),
      (Complaints{"31:11 E0305 'module' of 'gears' cannot be -2",
                  "32:19 E0305 'pressure_angle' of 'gears' cannot be 90",
                  "33:16 E0305 'helix_angle' of 'gears' cannot be -1.6 rad",
                  "36:36 E0305 'module' of mesh 'h' cannot be 0",
                  "36:55 E0305 'pressure_angle' of mesh 'h' cannot be -1",
                  "36:63 E0309 expected a length, found a force"}));
}

TEST(GearCheck, NeedsAModuleOrADistance) {
  const std::string meshes = "  meshes: {h: {members: [a, b], carrier: carrier}}\n";
  EXPECT_EQ(
      complaints_about("gears:\n"
                       "  members: {a: {body: sun, teeth: 9}, b: {body: planet, teeth: 9}}\n" +
                       meshes),
      (Complaints{"30:1 E0303 'gears' lacks the key 'module'"}));
  EXPECT_EQ(complaints_about("gears:\n"
                             "  members: {a: {body: sun, teeth: 9},\n"
                             "            b: {body: planet, teeth: 9, centre_distance: 9}}\n" +
                             meshes),
            Complaints{});
}

TEST(GearCheck, ReportsNamesThatAreNotDeclared) {
  const Diagnostics found = check_of(gear_set(
      "gears:\n"
      "  module: 1\n"
      "  members: {sun: {body: sn, teeth: 9}, p: {body: planet, teeth: 9}}\n"
      "  meshes: {h: {members: [sun, planet], carrier: carier}, k: {members: [sun, p]}}\n"));

  EXPECT_EQ(
      complaints_of(found),
      (Complaints{"32:25 E0312 gear member 'sun' is fixed to body 'sn', which is not declared",
                  "33:49 E0312 the carrier of mesh 'h' is body 'carier', which is not declared",
                  "33:31 E0313 mesh 'h' joins gear member 'planet', which is not declared"}));
  EXPECT_EQ(found.items()[1].hint,
            "declared bodies are housing, sun, planet, ring, carrier, shaft, block; did you mean "
            "'carrier'?");
}

TEST(GearCheck, RefusesTwoRings) {
  EXPECT_EQ(complaints_about(train("teeth: 40, internal: true", "teeth: 90, internal: true")),
            (Complaints{"34:26 E0314 mesh 'h' joins two rings, 'sun' and 'planet'"}));
}

TEST(GearCheck, RefusesARingThatIsSmallerThanItsGear) {
  EXPECT_EQ(complaints_about(train("teeth: 40", "teeth: 40, internal: true")),
            (Complaints{"34:26 E0314 mesh 'h' needs a ring with more teeth than its gear: 'planet' "
                        "has 40, 'sun' has 40"}));
}

TEST(GearCheck, RefusesAMeshOfOneMemberOrOneBody) {
  EXPECT_EQ(
      complaints_about("gears:\n"
                       "  module: 1\n"
                       "  members: {a: {body: planet, teeth: 9}, b: {body: planet, teeth: 9}}\n"
                       "  meshes: {h: {members: [a, a]}, k: {members: [a, b]}}\n"),
      (Complaints{"33:29 E0314 mesh 'h' joins gear member 'a' to itself",
                  "33:48 E0314 mesh 'k' joins two members of the same body 'planet'"}));
}

TEST(GearCheck, RefusesACarrierThatIsOneOfTheTwo) {
  EXPECT_EQ(
      complaints_about(train(
          "teeth: 9", "teeth: 9", "  meshes: {h: {members: [sun, planet], carrier: sun}}}\n")),
      (Complaints{"34:49 E0314 the carrier of mesh 'h' is the body of its member 'sun'"}));
}

TEST(GearCheck, NeedsACarrierForAWheelOfTheGround) {
  EXPECT_EQ(
      complaints_about("gears:\n"
                       "  module: 1\n"
                       "  members: {a: {body: housing, teeth: 9}, b: {body: planet, teeth: 9}}\n"
                       "  meshes: {h: {members: [a, b]}}\n"),
      (Complaints{"33:12 E0303 mesh 'h' needs a carrier: its member 'a' is fixed to the ground"}));
}

TEST(GearCheck, WarnsOfAMemberWithoutAMesh) {
  EXPECT_EQ(complaints_about("gears:\n"
                             "  module: 1\n"
                             "  members:\n"
                             "    a: {body: sun, teeth: 9}\n"
                             "    b: {body: planet, teeth: 9}\n"
                             "    idle: {body: ring, teeth: 9}\n"
                             "  meshes: {h: {members: [a, b], carrier: carrier}}\n"),
            (Complaints{"35:5 W0301 gear member 'idle' is in no mesh"}));
}

}  // namespace
}  // namespace kinestat
