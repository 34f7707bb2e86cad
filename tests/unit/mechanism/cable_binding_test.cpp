#include <cmath>

#include <gtest/gtest.h>

#include "format/mechanism_reader.hpp"
#include "mechanism/bind/bind.hpp"
#include "support/read_text.hpp"

namespace kinestat {
namespace {

Mechanism bound_with_cables(const std::string& text) {
  Diagnostics found;
  const auto root = read_yaml({.path = "test.yaml", .text = text}, ReadLimits{}, found);
  const auto description = root ? read_mechanism(*root, found) : std::nullopt;
  const auto mechanism = description ? bind(*description, found) : std::nullopt;
  EXPECT_EQ(complaints_of(found), Complaints{});
  return mechanism.value_or(Mechanism{});
}

// Two cables, of which the second belongs to a wheel that turns with it.
constexpr const char* kHoist =
    "kinestat: 1\n"
    "space: planar\n"
    "ground: frame\n"
    "bodies: [left, right, wheel, drum]\n"
    "couplings:\n"
    "  a: {type: prismatic, bodies: [frame, left], at: [0, 0], axis: y}\n"
    "  b: {type: prismatic, bodies: [frame, right], at: [6, 0], axis: y}\n"
    "  e: {type: revolute, bodies: [frame, wheel], at: [3, 10]}\n"
    "  d: {type: revolute, bodies: [frame, drum], at: [20, 0]}\n"
    "cables:\n"
    "  rope:\n"
    "    over:\n"
    "      - {body: left, at: [0, 0]}\n"
    "      - {pulley: wheel, radius: 3, wrap: clockwise, slip: true}\n"
    "      - {body: right, at: [6, 0]}\n"
    "  haul:\n"
    "    over: [{pulley: drum, radius: 1, wrap: clockwise}, {body: right, at: [6, 1]}]\n";

TEST(CableBinding, AddsSegmentsThenVirtualLinks) {
  const Mechanism mechanism = bound_with_cables(kHoist);
  const Topology& topology = mechanism.topology;

  std::vector<std::string> couplings;
  for (const CouplingTopology& one : topology.couplings) {
    couplings.push_back(topology.body(one.tail).name + " " + one.name + " " +
                        topology.body(one.head).name);
  }

  EXPECT_EQ(couplings,
            (std::vector<std::string>{"frame a left",
                                      "frame b right",
                                      "frame e wheel",
                                      "frame d drum",
                                      "left rope_1 rope_wheel",
                                      "rope_wheel rope_2 right",
                                      "wheel rope_wheel rope_wheel",
                                      "drum haul_1 right"}));
  EXPECT_EQ(topology.bodies.back().name, "rope_wheel");
}

TEST(CableBinding, PullsTheHeadTowardsTheTail) {
  const Mechanism mechanism = bound_with_cables(kHoist);
  const CouplingTopology& cable = mechanism.topology.couplings[4];

  // From (0, 0) up to (0, 10): the tension on the head, the link at the wheel, is downwards.
  const Wrench& tension = mechanism.geometry.actions[static_cast<std::size_t>(cable.first_action)];

  EXPECT_EQ(cable.action_count, 1);
  EXPECT_EQ(cable.freedom_count, 2);
  EXPECT_LE((tension.force - Vec3(0.0, -1.0, 0.0)).norm(), 1e-15);
  EXPECT_LE(tension.moment.norm(), 1e-15);
}

TEST(CableBinding, FreesMoreInSpace) {
  const std::string text =
      "kinestat: 1\n"
      "ground: frame\n"
      "bodies: [block, wheel]\n"
      "couplings:\n"
      "  a: {type: prismatic, bodies: [frame, block], at: [0, 0, 0], axis: z}\n"
      "  e: {type: revolute, bodies: [frame, wheel], at: [0, 3, 10], axis: x}\n"
      "cables:\n"
      "  rope:\n"
      "    over:\n"
      "      - {body: block, at: [0, 0, 0]}\n"
      "      - {pulley: wheel, radius: 3, wrap: clockwise, slip: true}\n"
      "      - {body: frame, at: [0, 6, 0]}\n";

  // About x, the axis of the revolute coupling, clockwise goes from -y over +z to +y.
  const Mechanism mechanism = bound_with_cables(text);

  ASSERT_EQ(mechanism.topology.couplings.size(), 5U);
  EXPECT_EQ(mechanism.topology.couplings[2].freedom_count, 5);
  EXPECT_LE((mechanism.geometry.points[2] - Vec3(0.0, 0.0, 10.0)).norm(), 1e-14);
  EXPECT_EQ(mechanism.topology.freedom_name(mechanism.topology.couplings[4].first_freedom),
            "rope_wheel.wx");
}

TEST(CableBinding, LeavesTheFileWithoutItsCablesWhereOneIsWrong) {
  std::string text = kHoist;
  text.replace(text.find("radius: 3"), 9, "radius: 9 deg");
  Diagnostics found;
  const auto root = read_yaml({.path = "test.yaml", .text = text}, ReadLimits{}, found);
  const auto description = read_mechanism(*root, found);
  ASSERT_TRUE(description);

  EXPECT_FALSE(bind(*description, found));

  EXPECT_EQ(complaints_of(found), (Complaints{"14:33 E0309 expected a length, found an angle"}));
}

}  // namespace
}  // namespace kinestat
