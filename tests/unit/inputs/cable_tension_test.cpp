#include "studies/inputs/cable_tension.hpp"

#include <map>
#include <string>

#include <gtest/gtest.h>

#include "support/mechanism_text.hpp"

namespace kinestat {
namespace {

constexpr double kClose = 1e-12;

using Actions = std::map<std::string, double>;

struct Found {
  CableTension cables;
  Actions drives;  // by freedom
};

Found find(const std::string& text) {
  const Mechanism mechanism = mechanism_of(text);
  const std::optional<CableTension> cables = find_cable_tension(mechanism);
  EXPECT_TRUE(cables);
  Found found{.cables = cables.value_or(CableTension{}), .drives = {}};
  for (const TensioningDrive& drive : found.cables.drives) {
    found.drives[mechanism.topology.freedom_name(drive.freedom)] = drive.action;
  }
  return found;
}

void expect_near(const Actions& actual, const Actions& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (const auto& [name, action] : expected) {
    ASSERT_TRUE(actual.contains(name)) << name;
    EXPECT_NEAR(actual.at(name), action, kClose) << name;
  }
}

// Blocks under as many pulleys as asked for, side by side, each with a cable that may slip.
std::string pulleys(int count) {
  std::string bodies;
  std::string couplings;
  std::string cables;
  for (int i = 0; i < count; ++i) {
    const std::string n = std::to_string(i);
    const std::string x = std::to_string(10 * i);
    bodies += (i == 0 ? "" : ", ") + ("left" + n) + ", right" + n + ", pulley" + n;
    couplings += "  a" + n + ": {type: prismatic, bodies: [frame, left" + n + "], at: [" + x +
                 " - 1, 0], axis: y}\n  b" + n + ": {type: prismatic, bodies: [frame, right" + n +
                 "], at: [" + x + " + 1, 0], axis: y}\n  e" + n +
                 ": {type: revolute, bodies: [frame, pulley" + n + "], at: [" + x + ", 5]}\n";
    cables += "  cable" + n + ":\n    over:\n      - {body: left" + n + ", at: [" + x +
              " - 1, 0]}\n      - {pulley: pulley" + n +
              ", radius: 1, wrap: clockwise, slip: true}\n      - {body: right" + n + ", at: [" +
              x + " + 1, 0]}\n";
  }
  return "space: planar\nground: frame\nbodies: [" + bodies + "]\ncouplings:\n" + couplings +
         "cables:\n" + cables;
}

TEST(CableTension, AreNoneWithoutRopes) {
  const Mechanism mechanism = mechanism_of(
      "ground: frame\nbodies: [crank]\n"
      "couplings: {a: {type: revolute, bodies: [frame, crank], at: [0, 0, 0], axis: z}}\n");

  EXPECT_FALSE(find_cable_tension(mechanism));
}

// The pulley and the cable move on their own: two actuators. Both ends pulled downwards: a third.
TEST(CableTension, OfAPulleyArePulledAtBothEnds) {
  const Found found = find(pulleys(1));

  EXPECT_TRUE(found.cables.is_possible);
  EXPECT_EQ(found.cables.segments, 2);
  EXPECT_EQ(found.cables.net_freedom, 2);
  EXPECT_EQ(found.cables.without_slip, 1);
  EXPECT_EQ(found.cables.actuators, 3);
  EXPECT_TRUE(found.cables.is_least());
  expect_near(found.drives, {{"a0.vy", -1.0}, {"b0.vy", -1.0}});
}

TEST(CableTension, OfTwoMachinesNeedTwoActuatorsMore) {
  const Found found = find(pulleys(2));

  EXPECT_EQ(found.cables.net_freedom, 4);
  EXPECT_EQ(found.cables.actuators, 6);
  EXPECT_FALSE(found.cables.is_least());  // not known to be
  expect_near(found.drives, {{"a0.vy", -1.0}, {"b0.vy", -1.0}, {"a1.vy", -1.0}, {"b1.vy", -1.0}});
}

TEST(CableTension, OfABeltKeepThemselvesTaut) {
  const Found found = find(
      "space: planar\nground: frame\nbodies: [driver, driven]\n"
      "couplings:\n"
      "  A: {type: revolute, bodies: [frame, driver], at: [0, 0]}\n"
      "  B: {type: revolute, bodies: [frame, driven], at: [5, 0]}\n"
      "cables:\n"
      "  belt:\n"
      "    closed: true\n"
      "    over: [{pulley: driver, radius: 1, wrap: clockwise},\n"
      "           {pulley: driven, radius: 2, wrap: clockwise}]\n");

  EXPECT_TRUE(found.cables.is_possible);
  EXPECT_EQ(found.cables.segments, 2);
  EXPECT_EQ(found.cables.actuators, 1);
  EXPECT_TRUE(found.drives.empty());
}

// A platform in the plane with winches: cables from (x, 0) along (u, v), drawn in by sliders.
std::string platform(int cables) {
  struct Rope {
    const char* at;
    const char* along;
    const char* end;
  };

  // The four forces sum to zero, and so do their moments -1, 1, -1/2, 1/2; no three of them do.
  const Rope all[] = {{"[-1, 0]", "[1, 1]", "[8, 9]"},
                      {"[1, 0]", "[-1, 1]", "[-8, 9]"},
                      {"[0.5, 0]", "[1, -1]", "[9.5, -9]"},
                      {"[-0.5, 0]", "[-1, -1]", "[-9.5, -9]"}};
  std::string bodies = "platform";
  std::string couplings;
  for (int i = 0; i < cables; ++i) {
    const std::string n = std::to_string(i);
    bodies += ", winch" + n;
    couplings += "  s" + n + ": {type: prismatic, bodies: [frame, winch" + n +
                 "], at: " + all[i].end + ", axis: " + all[i].along + "}\n  r" + n +
                 ": {type: cable, bodies: [platform, winch" + n + "], from: " + all[i].at +
                 ", to: " + all[i].end + "}\n";
  }
  return "space: planar\nground: frame\nbodies: [" + bodies + "]\ncouplings:\n" + couplings;
}

// n freedoms take n + 1 cables and winches.
TEST(CableTension, OfAPlanarCableRobotTakeOneWinchMoreThanItsFreedoms) {
  const Found found = find(platform(4));

  EXPECT_EQ(found.cables.net_freedom, 3);
  EXPECT_EQ(found.cables.actuators, 4);
  EXPECT_TRUE(found.cables.is_least());
  expect_near(found.drives, {{"s0.v", 1.0}, {"s1.v", 1.0}, {"s2.v", 1.0}, {"s3.v", 1.0}});
}

TEST(CableTension, OfACableRobotCannotBeTautWithAsManyRopesAsFreedoms) {
  const Found found = find(platform(3));

  EXPECT_EQ(found.cables.net_freedom, 3);
  EXPECT_FALSE(found.cables.is_possible);
  EXPECT_TRUE(found.drives.empty());
}

}  // namespace
}  // namespace kinestat
