#include <gtest/gtest.h>

#include "format/sections/sections.hpp"
#include "support/read_section.hpp"

namespace kinestat {
namespace {

auto cables_of(const std::string& text, Space space = Space::planar) {
  return read_form(cables(), "'cables'", text, space);
}

TEST(CableSection, ReadsARopeBetweenTwoPoints) {
  const auto reading = cables_of("rope: {over: [{body: a, at: [0, 1]}, {body: b, at: [2, 3]}]}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const CableDescription& cable = (*reading.value)[0];
  EXPECT_EQ(cable.name.text, "rope");
  EXPECT_FALSE(cable.closed);
  ASSERT_EQ(cable.over.size(), 2U);
  EXPECT_FALSE(cable.over[1].is_pulley);
  EXPECT_EQ(cable.over[1].body.text, "b");
  EXPECT_EQ(cable.over[1].at->coordinates[1].expression.text(), "3");
}

TEST(CableSection, ReadsEveryKeyOfAPulley) {
  const auto reading = cables_of(
      "rope:\n"
      "  over:\n"
      "    - {body: a, at: [0, 0, 0]}\n"
      "    - {pulley: wheel, at: [1, 2, 3], radius: 10 mm, wrap: counterclockwise, axis: -z,\n"
      "       slip: true, friction: 0.3, eta: 0.95, points: [[0, 0, 1], [0, 0, 2]]}\n"
      "    - {pulley: drum, radius: 1, wrap: clockwise}\n",
      Space::spatial);

  ASSERT_EQ(reading.complaints(), Complaints{});
  const CableStation& wheel = (*reading.value)[0].over[1];
  EXPECT_TRUE(wheel.is_pulley);
  EXPECT_EQ(wheel.body.text, "wheel");
  EXPECT_EQ(wheel.at->coordinates.size(), 3U);
  EXPECT_EQ(wheel.radius->expression.text(), "10 mm");
  EXPECT_EQ(wheel.wrap, Wrap::counterclockwise);
  EXPECT_EQ(wheel.axis->sign, -1.0);
  EXPECT_TRUE(wheel.slip);
  EXPECT_EQ(wheel.friction->expression.text(), "0.3");
  EXPECT_EQ(wheel.eta->expression.text(), "0.95");
  EXPECT_EQ(wheel.points.size(), 2U);
  EXPECT_FALSE((*reading.value)[0].over[2].slip);
}

TEST(CableSection, ReadsABelt) {
  const auto reading = cables_of(
      "belt: {over: [{pulley: a, radius: 1, wrap: clockwise},"
      " {pulley: b, points: [[0, 1], [1, 0]]}], closed: true}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  EXPECT_TRUE((*reading.value)[0].closed);
  EXPECT_FALSE((*reading.value)[0].over[1].radius);
}

TEST(CableSection, NeedsAListOfTwoStations) {
  EXPECT_EQ(cables_of("a: {}\nb: {over: [{body: a, at: [0, 1]}]}\nc: {over: wheel}\n").complaints(),
            (Complaints{"1:1 E0303 cable 'a' lacks the key 'over'",
                        "2:11 E0304 'over' of cable 'b' must be a list of at least two",
                        "3:11 E0304 'over' of cable 'c' must be a list of at least two"}));
}

TEST(CableSection, NeedsToKnowWhatAStationIs) {
  const auto reading = cables_of(
      "rope:\n"
      "  over:\n"
      "    - {at: [0, 1]}\n"
      "    - {body: a, pulley: w, radius: 1}\n"
      "    - {puley: w, radius: 1, wrap: clockwise}\n"
      "    - wheel\n");

  EXPECT_EQ(
      reading.complaints(),
      (Complaints{"3:7 E0303 station 1 of cable 'rope' lacks the key 'body' or 'pulley'",
                  "4:8 E0302 station 2 of cable 'rope' has both 'body' and 'pulley'",
                  "5:8 E0302 station 3 of cable 'rope' has no key 'puley'",
                  "6:7 E0304 station 4 of cable 'rope' must be a mapping of keys to values"}));
}

TEST(CableSection, NeedsPointRadiusAndWrap) {
  EXPECT_EQ(cables_of("rope: {over: [{body: a}, {pulley: w}]}\n").complaints(),
            (Complaints{"1:15 E0303 station 1 of cable 'rope' lacks the key 'at'",
                        "1:26 E0303 station 2 of cable 'rope' lacks the key 'radius'",
                        "1:26 E0303 station 2 of cable 'rope' lacks the key 'wrap'"}));
}

TEST(CableSection, RefusesKeysOfAPulleyOnAPoint) {
  EXPECT_EQ(cables_of("rope: {over: [{body: a, at: [0, 0], slip: true, radius: 2},"
                      " {body: b, at: [1, 1]}]}\n")
                .complaints(),
            (Complaints{"1:37 E0302 station 1 of cable 'rope' has no key 'slip'",
                        "1:49 E0302 station 1 of cable 'rope' has no key 'radius'"}));
}

TEST(CableSection, RefusesOtherSensesOfTurning) {
  const auto reading =
      cables_of("rope: {over: [{body: a, at: [0, 0]}, {pulley: w, radius: 1, wrap: clokwise}]}\n");

  EXPECT_EQ(reading.complaints(),
            (Complaints{"1:67 E0305 'wrap' of station 2 of cable 'rope' cannot be 'clokwise'"}));
  EXPECT_EQ(reading.found.items()[0].hint,
            "did you mean 'clockwise'? it is one of clockwise, counterclockwise");
}

TEST(CableSection, RefusesARopeThatSlipsOffItsEnd) {
  EXPECT_EQ(cables_of("rope: {over: [{body: a, at: [0, 0]},"
                      " {pulley: w, radius: 1, wrap: clockwise, slip: true}]}\n")
                .complaints(),
            (Complaints{"1:38 E0314 cable 'rope' ends on pulley 'w' and would slip off it"}));
}

TEST(CableSection, RefusesABeltThatIsFixedAtAPoint) {
  EXPECT_EQ(
      cables_of("belt: {over: [{body: a, at: [0, 0]},"
                " {pulley: w, radius: 1, wrap: clockwise}], closed: true}\n")
          .complaints(),
      (Complaints{"1:15 E0314 cable 'belt' is closed and cannot be fixed at a point of 'a'"}));
}

TEST(CableSection, RefusesPointsOfAnotherSpaceOrNumber) {
  EXPECT_EQ(cables_of("rope: {over: [{body: a, at: [0, 0, 0]}, {pulley: w, points: [[0, 0]]}]}\n")
                .complaints(),
            (Complaints{"1:29 E0304 'at' of station 1 of cable 'rope' has 3 components, planar "
                        "space needs 2",
                        "1:61 E0304 'points' of station 2 of cable 'rope' must be a list of two"}));
}

TEST(CableSection, RefusesAListAndANameWithASpace) {
  EXPECT_EQ(
      cables_of("the rope: {over: [{body: a, at: [0, 1]}, {body: b, at: [2, 3]}]}\n").complaints(),
      (Complaints{"1:1 E0306 'the rope' cannot be the name of a cable"}));
}

}  // namespace
}  // namespace kinestat
