#include "mechanism/check/declared_names.hpp"

#include <gtest/gtest.h>

#include "unit/mechanism/checked_text.hpp"

namespace kinestat {
namespace {

TEST(NameTable, KeepsTheFirstOfTwo) {
  NameTable bodies("E0312", "body", "bodies");
  EXPECT_FALSE(bodies.add({.text = "a", .where = {.line = 1, .column = 2, .length = 1}}));

  const auto first = bodies.add({.text = "a", .where = {.line = 3, .column = 4, .length = 1}});

  ASSERT_TRUE(first);
  EXPECT_EQ(first->line, 1);
  EXPECT_EQ(bodies.find("a"), 0);
  EXPECT_EQ(bodies.find("b"), -1);
}

TEST(NameTable, SaysWhatIsDeclared) {
  NameTable bodies("E0312", "body", "bodies");
  EXPECT_EQ(bodies.hint("a"), "the file declares no bodies");

  bodies.add({.text = "rocker", .where = {}});
  EXPECT_EQ(bodies.hint("rockr"), "declared bodies are rocker; did you mean 'rocker'?");
  EXPECT_EQ(bodies.hint("q"), "declared bodies are rocker");
}

TEST(DeclaredNames, RefusesAMeshNamedLikeACouplingOrActuator) {
  const Diagnostics found =
      check_of(gear_set("gears:\n"
                        "  module: 1\n"
                        "  members: {x: {body: sun, teeth: 9}, y: {body: planet, teeth: 9}}\n"
                        "  meshes: {a: {members: [x, y]}, in: {members: [x, y]}}\n"));

  EXPECT_EQ(complaints_of(found),
            (Complaints{"33:12 E0307 'a' is already the name of a coupling or actuator",
                        "33:34 E0307 'in' is already the name of a coupling or actuator"}));
  ASSERT_EQ(found.items()[0].notes.size(), 1U);
  EXPECT_EQ(found.items()[0].notes[0].where.line, 8);
}

TEST(DeclaredNames, RefusesWhatACableMakesIfTheNameIsTaken) {
  const std::string text =
      "kinestat: 1\n"
      "ground: frame\n"
      "bodies: [block, wheel, rope_wheel]\n"
      "couplings:\n"
      "  a: {type: revolute, bodies: [frame, wheel], at: [0, 0, 0], axis: z}\n"
      "  b: {type: revolute, bodies: [frame, rope_wheel], at: [0, 0, 0], axis: z}\n"
      "  rope_1: {type: prismatic, bodies: [frame, block], axis: y}\n"
      "actuators: {rope_2: {coupling: a}}\n"
      "cables:\n"
      "  rope:\n"
      "    over:\n"
      "      - {body: block, at: [0, 0, 0]}\n"
      "      - {pulley: wheel, radius: 1, wrap: clockwise, slip: true}\n"
      "      - {body: frame, at: [0, 0, 0]}\n";

  EXPECT_EQ(
      complaints_of(check_of(text)),
      (Complaints{
          "10:3 E0307 cable 'rope' makes 'rope_1', which is already the name of a coupling or "
          "actuator",
          "10:3 E0307 cable 'rope' makes 'rope_2', which is already the name of a coupling or "
          "actuator",
          "10:3 E0307 cable 'rope' makes 'rope_wheel', which is already the name of a body"}));
}

TEST(DeclaredNames, NumberASecondContactOfARopeWithTheSameWheel) {
  CableDescription cable;
  cable.name.text = "rope";
  for (int i = 0; i < 3; ++i) {
    CableStation wheel;
    wheel.is_pulley = true;
    wheel.slip = i != 1;
    wheel.body.text = "wheel";
    cable.over.push_back(wheel);
  }

  EXPECT_EQ(segment_count(cable), 2);
  EXPECT_EQ(segment_name(cable, 2), "rope_2");
  const std::vector<VirtualLink> links = virtual_links(cable);
  ASSERT_EQ(links.size(), 2U);
  EXPECT_EQ(links[0].name, "rope_wheel");
  EXPECT_EQ(links[1].name, "rope_wheel_2");
  EXPECT_EQ(links[1].station, 2U);
  cable.closed = true;
  EXPECT_EQ(segment_count(cable), 3);
}

TEST(DeclaredNames, KnowWhatAnActuatorMoves) {
  Diagnostics found;
  const auto root = read_yaml({.path = "t", .text = gear_set("")}, ReadLimits{}, found);
  const auto description = read_mechanism(*root, found);
  ASSERT_TRUE(description);

  const DeclaredNames names = declare_names(*description, found);

  EXPECT_EQ(names.kind_of_actuator("in"), DriveKind::turning);
  EXPECT_EQ(names.kind_of_actuator("C1"), DriveKind::turning);
  EXPECT_EQ(names.kind_of_actuator("lift"), DriveKind::sliding);
  EXPECT_EQ(names.kind_of_actuator("none"), DriveKind::unknown);
}

}  // namespace
}  // namespace kinestat
