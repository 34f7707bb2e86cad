#include <gtest/gtest.h>

#include "couplings/kinds.hpp"
#include "format/sections/sections.hpp"
#include "support/read_section.hpp"

namespace kinestat {
namespace {

auto couplings_of(const std::string& text, Space space = Space::spatial) {
  return read_form(couplings(), "'couplings'", text, space);
}

std::string written_text(const std::vector<CouplingDescription>& all) {
  return behind_key(couplings().write(all), 0);
}

// Every type with the keys that the format gives it.
const std::vector<std::string> kFullest = {
    "{type: revolute, bodies: [f, g], at: [0, 0, 0], axis: z, passive: [Rx], friction: {tau: 1}}",
    "{type: prismatic, bodies: [f, g], at: [0, 0, 0], axis: [1, 0, 1]}",
    "{type: helical, bodies: [f, g], at: [0, 0, 0], axis: z, lead: 5 mm}",
    "{type: helical, bodies: [f, g], at: [0, 0, 0], axis: z, pitch: 1 mm}",
    "{type: cylindrical, bodies: [f, g], at: [0, 0, 0], axis: z}",
    "{type: universal, bodies: [f, g], at: [0, 0, 0], axes: [x, z]}",
    "{type: spherical, bodies: [f, g], at: [0, 0, 0], stiffness: {Rx: 2e6 N/m}}",
    "{type: planar, bodies: [f, g], normal: z}",
    "{type: point_contact, bodies: [f, g], at: [0, 0, 0], normal: z}",
    "{type: cam, bodies: [f, g], at: [0, 0, 0], normal: z}",
    "{type: line_contact, bodies: [f, g], at: [0, 0, 0], normal: z, line: x}",
    "{type: sphere_in_tube, bodies: [f, g], at: [0, 0, 0], axis: z}",
    "{type: pin_in_slot, bodies: [f, g], at: [0, 0, 0], slot: x}",
    "{type: rigid, bodies: [f, g]}",
    "{type: gear, bodies: [f, g], at: [0, 0, 0], axis: z, tangent: x, pressure_angle: 20 deg, "
    "helix_angle: 10 deg, internal: true, contact: true}",
    "{type: gear, bodies: [f, g], at: [0, 0, 0], axis: z, line_of_action: x}",
    "{type: bevel_gear, bodies: [f, g], at: [0, 0, 0], axis: [0, 1, 1], line_of_action: x}",
    "{type: worm, bodies: [f, g], at: [0, 0, 0], line_of_action: x, "
    "screw: {rotation: z, at: [0, 0, 0], pitch: 2 mm}}",
    "{type: rack, bodies: [f, g], at: [0, 0, 0], axis: z, line_of_action: x}",
    "{type: clutch, bodies: [f, g], at: [0, 0, 0], axis: z, one_way: +}",
    "{type: brake, bodies: [f, g], at: [0, 0, 0], axis: z, one_way: '-'}",
    "{type: torque_converter, bodies: [f, g], at: [0, 0, 0], axis: z, stator: h, characteristic: "
    "{speed_ratio: [0, 1], torque_ratio: 2 - speed_ratio, pump_torque: [100, 0], "
    "pump_speed: 2000 rpm}}",
    "{type: torque_converter, bodies: [f, g], at: [0, 0, 0], axis: z, characteristic: "
    "{lambda: 3e-3*(1 - speed_ratio), density: 860 kg/m^3, diameter: 260 mm}}",
    "{type: cable, bodies: [f, g], from: [0, 0, 0], to: [1, 0, 0]}",
    "{type: screws, bodies: [f, g], freedoms: [{rotation: z, at: [0, 0, 0]}, {translation: x}], "
    "constraints: [{force: y, at: [0, 0, 0]}, {couple: [1, 0, 0]}]}",
};

class EveryCoupling : public testing::TestWithParam<std::string> {};

TEST_P(EveryCoupling, TakesItsKeys) {
  const auto reading = couplings_of("a: " + GetParam() + "\n");

  EXPECT_EQ(reading.complaints(), Complaints{});
  EXPECT_EQ(reading.value->size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(CouplingSection, EveryCoupling, testing::ValuesIn(kFullest));

TEST(CouplingSection, TakesTheExampleOfEveryKindAndWritesItAsItWasRead) {
  for (const CouplingKind* kind : coupling_kinds()) {
    SCOPED_TRACE(kind->word);
    const std::string text = "a: " + std::string(kind->example) + "\n";
    const bool is_planar = couplings_of(text, Space::planar).complaints().empty();
    const Space space = is_planar ? Space::planar : Space::spatial;
    const auto reading = couplings_of(text, space);
    ASSERT_EQ(reading.complaints(), Complaints{});
    ASSERT_EQ(reading.value->front().type, kind->type);

    const std::string written = written_text(*reading.value);

    const auto again = couplings_of(written, space);
    ASSERT_EQ(again.complaints(), Complaints{});
    EXPECT_EQ(written_text(*again.value), written);
  }
}

TEST(CouplingSection, TakesTheKeysOfFrictionThatTheTypeUses) {
  const auto complaints = [](const std::string& coupling) {
    return couplings_of("a: {" + coupling + "}\n").complaints();
  };
  const std::string hinge = "type: revolute, bodies: [f, g], at: [0, 0, 0], axis: z, friction: ";
  const std::string guide = "type: prismatic, bodies: [f, g], axis: z, friction: ";

  EXPECT_EQ(complaints(hinge + "{mu: 0.1, radius: 5 mm, tau: 1, c: 2}"), Complaints{});
  EXPECT_EQ(complaints(guide + "{mu: 0.1, length: 5 mm, c: 2}"), Complaints{});
  EXPECT_EQ(complaints(hinge + "{mu: 0.1}").size(), 1U);
  EXPECT_EQ(complaints(hinge + "0.1").size(), 1U);
  EXPECT_EQ(complaints(hinge + "{mu: 0.1, radius: 5 mm, thrust_radius: 6 mm, length: 9 mm}"),
            Complaints{});
  EXPECT_EQ(complaints(guide + "{mu: 0.1, radius: 5 mm}"), Complaints{});
  EXPECT_EQ(complaints(guide + "{mu: 0.1, thrust_radius: 5 mm}").size(), 1U);
}

TEST(CouplingSection, ReadsWhatIsWritten) {
  const auto reading = couplings_of(
      "a: {type: worm, bodies: [f, g], at: [0, 0, 1], line_of_action: x, "
      "screw: {rotation: -z, at: [0, 2, 0], pitch: 3 mm}, "
      "friction: {mu: 0.1}, stiffness: {Rx: 4, Tz: 5}}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const CouplingDescription& a = (*reading.value)[0];
  EXPECT_EQ(a.type, CouplingType::worm);
  EXPECT_EQ(a.tail.text, "f");
  EXPECT_EQ(a.at->point->coordinates[2].expression.text(), "1");
  EXPECT_EQ(a.screw->kind, ScrewWord::rotation);
  EXPECT_EQ(a.screw->direction.sign, -1.0);
  EXPECT_EQ(a.screw->pitch->expression.text(), "3 mm");
  EXPECT_EQ(a.friction->mu->expression.text(), "0.1");
  EXPECT_FALSE(a.friction->radius);
  EXPECT_EQ(a.stiffness[1].action.text, "Tz");
  EXPECT_FALSE(a.passive);
}

TEST(CouplingSection, KnowsTheKeysOfEachTypeOnly) {
  EXPECT_EQ(couplings_of("a: {type: spherical, bodies: [f, g], at: [0, 0, 0], axis: z}\n"
                         "b: {type: revolute, bodies: [f, g], at: [0, 0, 0], axes: [x, y]}\n"
                         "c: {type: rigid, bodies: [f, g], pressure_angle: 20 deg}\n")
                .complaints(),
            (Complaints{"1:53 E0302 coupling 'a' has no key 'axis'",
                        "2:52 E0302 coupling 'b' has no key 'axes'",
                        "3:34 E0302 coupling 'c' has no key 'pressure_angle'"}));
}

TEST(CouplingSection, ReadsThePointAsDrawnOnEachBody) {
  const auto reading = couplings_of(
      "a: {type: revolute, bodies: [f, g], at: {f: [1, 3], g: [1.02, 3]}}\n", Space::planar);

  ASSERT_EQ(reading.complaints(), Complaints{});
  const CouplingPoint& at = *(*reading.value)[0].at;
  EXPECT_FALSE(at.point);
  ASSERT_EQ(at.of_bodies.size(), 2U);
  EXPECT_EQ(at.of_bodies[1].first.text, "g");
  EXPECT_EQ(at.of_bodies[1].second.coordinates[0].expression.text(), "1.02");
}

TEST(CouplingSection, ReadsAPositionAlongTheAxis) {
  const auto reading = couplings_of("a: {type: revolute, bodies: [f, g], at: 10 mm, axis: z}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  EXPECT_EQ((*reading.value)[0].at->along_axis->expression.text(), "10 mm");
}

TEST(CouplingSection, ExplainsPointsOfOtherForms) {
  EXPECT_EQ(couplings_of("a: {type: revolute, bodies: [f, g], at: {x: 1, y: 3}}\n"
                         "b: {type: revolute, bodies: [f, g], at: {f: [1, 3]}}\n"
                         "c: {type: revolute, bodies: [f, g], at: [1, 2, 3]}\n"
                         "d: {type: revolute, bodies: [f, g], at: [1,5, 2,0]}\n",
                         Space::planar)
                .complaints(),
            (Complaints{"1:41 E0304 the point of coupling 'a' is a mapping of coordinates",
                        "2:41 E0304 the point of coupling 'b' is given for 1 body",
                        "3:41 E0304 the point of coupling 'c' has 3 components, planar space "
                        "needs 2",
                        "4:41 E0304 the point of coupling 'd' has 4 components, planar space "
                        "needs 2"}));
}

TEST(CouplingSection, WantsOneKindOfAScrew) {
  EXPECT_EQ(couplings_of("a: {type: screws, bodies: [f, g], freedoms: [{}, {rotation: z, "
                         "translation: x}, {translation: x, at: [0, 0, 0]}]}\n")
                .complaints(),
            (Complaints{"1:46 E0303 a screw of coupling 'a' needs one of rotation and translation",
                        "1:50 E0303 a screw of coupling 'a' needs one of rotation and translation",
                        "1:98 E0302 a screw of coupling 'a' has no key 'at'"}));
}

TEST(CouplingSection, GuessesTypesByTheirOtherNames) {
  const auto reading = couplings_of("a: {type: hinge, bodies: [f, g]}\n");

  ASSERT_EQ(reading.found.items().size(), 1U);
  EXPECT_TRUE(reading.found.items()[0].hint.starts_with("did you mean 'revolute'?"));
}

}  // namespace
}  // namespace kinestat
