#include <gtest/gtest.h>

#include "format/sections/sections.hpp"
#include "support/read_section.hpp"

namespace kinestat {
namespace {

auto gears_of(const std::string& text) {
  return read_section(gears_section(), "'gears'", text);
}

TEST(GearSection, ReadsTheSmallestSection) {
  const auto reading = gears_of(
      "members: {sun: {body: s, teeth: 19}, planet: {body: p, teeth: 15}}\n"
      "meshes: {h: {members: [sun, planet]}}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const GearsDescription& gears = *reading.value;
  EXPECT_FALSE(gears.module);
  EXPECT_EQ(gears.flank, Flank::loaded);
  ASSERT_EQ(gears.members.size(), 2U);
  EXPECT_EQ(gears.members[1].name.text, "planet");
  EXPECT_EQ(gears.members[1].body.text, "p");
  EXPECT_EQ(gears.members[1].teeth.expression.text(), "15");
  EXPECT_FALSE(gears.members[1].internal);
  EXPECT_FALSE(gears.members[1].count);
  EXPECT_EQ(gears.members[1].side, PlanetSide::left);
  ASSERT_EQ(gears.meshes.size(), 1U);
  EXPECT_EQ(gears.meshes[0].first.text, "sun");
  EXPECT_EQ(gears.meshes[0].second.text, "planet");
  EXPECT_FALSE(gears.meshes[0].carrier);
}

TEST(GearSection, ReadsAxes) {
  const auto reading = gears_of(
      "axes:\n"
      "  main: {bodies: [s]}\n"
      "  lay: {bodies: [l, i], centre_distance: 80 mm, side: right}\n"
      "members: {sun: {body: s, teeth: 19}, planet: {body: l, teeth: 15}}\n"
      "meshes: {h: {members: [sun, planet]}}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const std::vector<GearAxisDescription>& axes = reading.value->axes;
  ASSERT_EQ(axes.size(), 2U);
  EXPECT_EQ(axes[0].name.text, "main");
  EXPECT_FALSE(axes[0].centre_distance);
  EXPECT_EQ(axes[0].side, PlanetSide::left);
  ASSERT_EQ(axes[1].bodies.size(), 2U);
  EXPECT_EQ(axes[1].bodies[1].text, "i");
  EXPECT_EQ(axes[1].centre_distance->expression.text(), "80 mm");
  EXPECT_EQ(axes[1].side, PlanetSide::right);
}

TEST(GearSection, ReadsEveryKey) {
  const auto reading = gears_of(
      "module: 2 mm\n"
      "pressure_angle: alpha\n"
      "helix_angle: -15 deg\n"
      "flank: fixed\n"
      "members:\n"
      "  planet: {body: p, teeth: N1, count: 3, centre_distance: 34, side: right}\n"
      "  ring: {body: r, teeth: N1 + 2*N5, internal: true}\n"
      "meshes:\n"
      "  k: {members: [ring, planet], carrier: c, at: 10, module: 2.5, pressure_angle: 14.5,\n"
      "      helix_angle: 1}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const GearsDescription& gears = *reading.value;
  EXPECT_EQ(gears.module->expression.text(), "2 mm");
  EXPECT_EQ(gears.pressure_angle->expression.text(), "alpha");
  EXPECT_EQ(gears.helix_angle->expression.text(), "-15 deg");
  EXPECT_EQ(gears.flank, Flank::fixed);
  EXPECT_EQ(gears.members[0].count->expression.text(), "3");
  EXPECT_EQ(gears.members[0].centre_distance->expression.text(), "34");
  EXPECT_EQ(gears.members[0].side, PlanetSide::right);
  EXPECT_TRUE(gears.members[1].internal);
  const MeshDescription& mesh = gears.meshes[0];
  EXPECT_EQ(mesh.carrier->text, "c");
  EXPECT_EQ(mesh.at->expression.text(), "10");
  EXPECT_EQ(mesh.module->expression.text(), "2.5");
  EXPECT_EQ(mesh.pressure_angle->expression.text(), "14.5");
  EXPECT_EQ(mesh.helix_angle->expression.text(), "1");
}

TEST(GearSection, NeedsMembersAndMeshes) {
  EXPECT_EQ(gears_of("module: 1\n").complaints(),
            (Complaints{"1:1 E0303 'gears' lacks the key 'members'",
                        "1:1 E0303 'gears' lacks the key 'meshes'"}));
}

TEST(GearSection, NeedsBodyAndTeethOfAMember) {
  EXPECT_EQ(gears_of("members: {sun: {}}\nmeshes: {h: {}}\n").complaints(),
            (Complaints{"1:11 E0303 gear member 'sun' lacks the key 'body'",
                        "1:11 E0303 gear member 'sun' lacks the key 'teeth'",
                        "2:10 E0303 mesh 'h' lacks the key 'members'"}));
}

TEST(GearSection, ReportsEveryUnknownKeyAtItsPlace) {
  const auto reading = gears_of(
      "modul: 1\n"
      "members: {sun: {body: s, teth: 19}}\n"
      "meshes: {h: {members: [sun, planet], carier: c}}\n");

  EXPECT_EQ(reading.complaints(),
            (Complaints{"2:26 E0302 gear member 'sun' has no key 'teth'",
                        "3:38 E0302 mesh 'h' has no key 'carier'",
                        "1:1 E0302 'gears' has no key 'modul'"}));
  EXPECT_EQ(reading.found.items()[2].hint,
            "did you mean 'module'? known keys are module, pressure_angle, "
            "normal_pressure_angle, helix_angle, flank, "
            "axes, members, meshes");
}

TEST(GearSection, RefusesWordsThatItDoesNotKnow) {
  EXPECT_EQ(gears_of("flank: lodaed\n"
                     "members: {sun: {body: s, teeth: 9, side: top, internal: yes}}\n"
                     "meshes: {}\n")
                .complaints(),
            (Complaints{"1:8 E0305 'flank' of 'gears' cannot be 'lodaed'",
                        "2:57 E0304 'internal' of gear member 'sun' cannot be 'yes'",
                        "2:42 E0305 'side' of gear member 'sun' cannot be 'top'"}));
}

TEST(GearSection, RefusesNamesThatCannotBeWritten) {
  EXPECT_EQ(gears_of("members: {2nd: {body: s, teeth: 9}}\n"
                     "meshes: {h 1: {members: [a, b]}}\n")
                .complaints(),
            (Complaints{"1:11 E0306 '2nd' cannot be the name of a gear member",
                        "2:10 E0306 'h 1' cannot be the name of a mesh"}));
}

TEST(GearSection, RefusesAMeshOfThree) {
  const auto reading =
      gears_of("members: {}\nmeshes: {h: {members: [a, b, c]}, k: {members: a}}\n");

  EXPECT_EQ(reading.complaints(),
            (Complaints{"2:23 E0304 'members' of mesh 'h' must be a list of two",
                        "2:48 E0304 'members' of mesh 'k' must be a list of two"}));
}

TEST(GearSection, RefusesKeysOfAPlanetOnARing) {
  EXPECT_EQ(gears_of("members:\n"
                     "  r: {body: b, teeth: 85, internal: true, count: 3, side: left}\n"
                     "meshes: {}\n")
                .complaints(),
            (Complaints{"2:43 E0302 gear member 'r' is a ring and cannot have 'count'",
                        "2:53 E0302 gear member 'r' is a ring and cannot have 'side'"}));
}

TEST(GearSection, RefusesAList) {
  EXPECT_EQ(gears_of("members: [a, b]\nmeshes: 3\n").complaints(),
            (Complaints{"1:10 E0304 'members' of 'gears' must be a mapping of names",
                        "2:9 E0304 'meshes' of 'gears' must be a mapping of names"}));
}

TEST(GearSection, MarksTheWrongPartOfAnExpression) {
  EXPECT_EQ(gears_of("module: 2 +\nmembers: {s: {body: s, teeth: (9}}\nmeshes: {}\n")
                .found.items()
                .size(),
            2U);
}

}  // namespace
}  // namespace kinestat
