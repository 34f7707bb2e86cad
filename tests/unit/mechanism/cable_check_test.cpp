#include "mechanism/cables/internal/cable_check.hpp"

#include <gtest/gtest.h>

#include "unit/mechanism/checked_text.hpp"

namespace kinestat {
namespace {

// A block on a slider and a wheel on a pin; the stations begin in line 12.
std::string hoist(const std::string& stations, const std::string& rest = "") {
  return "kinestat: 1\n"
         "space: planar\n"
         "units: {length: mm}\n"
         "ground: frame\n"
         "bodies: [block, wheel, plate]\n"
         "couplings:\n"
         "  a: {type: revolute, bodies: [frame, wheel], at: [0, 0]}\n"
         "  b: {type: prismatic, bodies: [frame, block], axis: y}\n"
         "cables:\n"
         "  rope:\n"
         "    over:\n" +
         stations + rest;
}

TEST(CableCheck, AcceptsAHoist) {
  EXPECT_EQ(complaints_of(check_of(
                hoist("      - {body: block, at: [-10, -30]}\n"
                      "      - {pulley: wheel, radius: 10, wrap: counterclockwise, slip: true,\n"
                      "         friction: 0, eta: 1, axis: -z}\n"
                      "      - {pulley: plate, at: [10, -30], radius: 2, wrap: clockwise}\n"))),
            Complaints{});
}

TEST(CableCheck, ReportsBodiesThatAreNotDeclared) {
  EXPECT_EQ(complaints_of(check_of(hoist("      - {body: blok, at: [0, 0]}\n"
                                         "      - {pulley: weel, radius: 1, wrap: clockwise}\n"))),
            (Complaints{"12:16 E0312 cable 'rope' ends on body 'blok', which is not declared",
                        "13:18 E0312 cable 'rope' wraps body 'weel', which is not declared"}));
}

TEST(CableCheck, WantsNumbersThatCanBe) {
  EXPECT_EQ(complaints_of(check_of(hoist(
                "      - {body: block, at: [0, 3 deg]}\n"
                "      - {pulley: wheel, radius: 0, wrap: clockwise, friction: -0.1, eta: 0}\n"
                "      - {pulley: plate, points: [[0, 1], [1 s, 1]]}\n"))),
            (Complaints{"12:31 E0309 expected a length, found an angle",
                        "13:33 E0305 'radius' of pulley 'wheel' of cable 'rope' cannot be 0",
                        "13:63 E0305 'friction' of pulley 'wheel' of cable 'rope' cannot be -0.1",
                        "13:74 E0305 'eta' of pulley 'wheel' of cable 'rope' cannot be 0",
                        "14:43 E0309 expected a length, found a time"}));
}

TEST(CableCheck, NeedsTheCentreOfAPulleyWithoutARevolute) {
  EXPECT_EQ(complaints_of(check_of(hoist("      - {body: block, at: [0, 0]}\n"
                                         "      - {pulley: plate, radius: 1, wrap: clockwise}\n"))),
            (Complaints{"13:9 E0314 pulley 'plate' of cable 'rope' has no centre: no revolute "
                        "coupling joins its body"}));
}

TEST(CableCheck, RefusesAPulleyThatTurnsOutOfThePlane) {
  EXPECT_EQ(complaints_of(
                check_of(hoist("      - {body: block, at: [0, 0]}\n"
                               "      - {pulley: wheel, radius: 1, wrap: clockwise, axis: x}\n"))),
            (Complaints{"13:59 E0314 pulley 'wheel' of cable 'rope' of a planar mechanism turns "
                        "about z"}));
}

TEST(CableCheck, RefusesASegmentWithinOneBody) {
  EXPECT_EQ(complaints_of(check_of(hoist("      - {body: block, at: [0, 0]}\n"
                                         "      - {body: block, at: [1, 0]}\n"
                                         "      - {body: frame, at: [1, 0]}\n"))),
            (Complaints{"13:16 E0314 segment 'rope_1' joins body 'block' to itself"}));
}

TEST(CableCheck, LetsARopeSlipTwiceOverOneWheel) {
  EXPECT_EQ(complaints_of(check_of(hoist(
                "      - {body: block, at: [-1, -30]}\n"
                "      - {pulley: wheel, radius: 1, wrap: clockwise, slip: true}\n"
                "      - {pulley: plate, at: [20, 0], radius: 1, wrap: clockwise, slip: true}\n"
                "      - {pulley: wheel, radius: 1, wrap: clockwise, slip: true}\n"
                "      - {body: frame, at: [0, 30]}\n"))),
            Complaints{});
}

TEST(CableCheck, NeedsTheCentreOfAPulleyOnTheGround) {
  EXPECT_EQ(complaints_of(
                check_of(hoist("      - {body: block, at: [0, 0]}\n"
                               "      - {pulley: frame, radius: 1, wrap: clockwise, slip: true}\n"
                               "      - {body: block, at: [5, 0]}\n"))),
            (Complaints{"13:9 E0314 pulley 'frame' of cable 'rope' has no centre: no revolute "
                        "coupling joins its body"}));
}

TEST(CableCheck, RefusesARopeThatCannotRun) {
  EXPECT_EQ(complaints_of(check_of(hoist(
                "      - {body: block, at: [0, 9]}\n"
                "      - {pulley: wheel, radius: 10, wrap: clockwise, slip: true}\n"
                "      - {pulley: plate, at: [30, 0], radius: 21, wrap: counterclockwise}\n"))),
            (Complaints{"12:9 E0317 segment 'rope_1' ends within pulley 'wheel': 9 mm from its "
                        "centre, and the radius is 10 mm",
                        "14:9 E0317 segment 'rope_2' crosses over between pulleys 'wheel' and "
                        "'plate', which overlap: centres 30 mm apart, radii 10 mm and 21 mm"}));
}

TEST(CableCheck, RefusesASegmentThroughAnotherPulley) {
  EXPECT_EQ(complaints_of(
                check_of(hoist("      - {body: block, at: [-10, -30]}\n"
                               "      - {pulley: wheel, radius: 10, wrap: clockwise, slip: true}\n"
                               "      - {pulley: plate, at: [40, 40], radius: 2, wrap: clockwise}\n"
                               "      - {body: frame, at: [-30, -10]}\n"))),
            (Complaints{"13:9 E0317 segment 'rope_3' passes through pulley 'wheel'"}));
}

TEST(CableCheck, TakesPulleysOnOneAxleToStandSideBySide) {
  EXPECT_EQ(complaints_of(check_of(hoist(
                "      - {body: block, at: [-10, -30]}\n"
                "      - {pulley: wheel, radius: 10, wrap: clockwise, slip: true}\n"
                "      - {pulley: plate, at: [3, -50], radius: 5, wrap: clockwise, slip: true}\n"
                "      - {pulley: wheel, radius: 4, wrap: clockwise, slip: true}\n"
                "      - {body: frame, at: [30, -80]}\n"))),
            Complaints{});
}

}  // namespace
}  // namespace kinestat
