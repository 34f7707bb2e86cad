#include <gtest/gtest.h>

#include "mechanism/check/section_checks.hpp"
#include "unit/mechanism/checked_text.hpp"

namespace kinestat {
namespace {

const std::string kShift = "shift:\n  input: in\n  output: out\n  elements: [C1, B1]\n";

TEST(ShiftCheck, AcceptsClutchesAndBrakes) {
  EXPECT_EQ(complaints_about("shift:\n"
                             "  input: in\n"
                             "  output: out\n"
                             "  elements: [C1, B1]\n"
                             "  input_motion: 1 rad/s\n"
                             "  input_action: {in: T}\n"
                             "  names: {G1: [C1, B1], N: []}\n"),
            Complaints{});
}

TEST(ShiftCheck, WantsLimitsOfWhatThereIs) {
  EXPECT_EQ(complaints_about(kShift +
                             "  input_action: 1\n"
                             "  limits: {torque: {C1: 2 N*m, in: 3}, slip: 2 N, speed: {sn: 1}}\n"),
            (Complaints{"35:32 E0313 'torque' of 'limits' names 'in', which is not in 'elements'",
                        "35:46 E0309 expected an angular velocity, found a force",
                        "35:59 E0312 'speed' of 'limits' names body 'sn', which is not declared"}));
}

TEST(ShiftCheck, WantsLimitsAboveZero) {
  EXPECT_EQ(complaints_about(kShift + "  input_action: 1\n"
                                      "  limits: {torque: T - T, planet_speed: -1 rpm}\n"),
            (Complaints{"35:20 E0305 'torque' of 'limits' cannot be T - T = 0 N*m",
                        "35:41 E0305 'planet_speed' of 'limits' cannot be -1 rpm"}));
}

TEST(ShiftCheck, WantsATorqueOfTheInputForLimitsOfTorques) {
  EXPECT_EQ(complaints_about(kShift + "  limits: {torque: 5}\n"),
            (Complaints{"34:20 E0303 'torque' of 'limits' needs the key 'input_action' of "
                        "'shift'"}));
}

TEST(ShiftCheck, RefusesElementsThatDoNotShift) {
  EXPECT_EQ(complaints_about("shift: {input: in, output: out, elements: [C1, lift]}\n"),
            (Complaints{"30:48 E0305 'lift' is neither a clutch nor a brake"}));
}

TEST(ShiftCheck, ReportsLabelsThatNameOtherElements) {
  EXPECT_EQ(complaints_about("shift: {input: in, output: out, elements: [C1, B1], "
                             "names: {C1: [B1], C1+B1: [B1, C1]}}\n"),
            (Complaints{"30:61 E0307 gear 'C1' engages other elements than its label says"}));
}

TEST(ShiftCheck, ReportsActuatorsThatAreNotDeclared) {
  const Diagnostics found =
      check_of(gear_set("shift: {input: inn, output: c, elements: [C1, B7]}\n"));

  EXPECT_EQ(
      complaints_of(found),
      (Complaints{
          "30:16 E0313 'input' of 'shift' names actuator 'inn', which is not declared",
          "30:29 E0313 'output' of 'shift' names 'c', which is a coupling and not an actuator",
          "30:47 E0313 'elements' of 'shift' names actuator 'B7', which is not declared"}));
  EXPECT_EQ(found.items()[0].hint,
            "declared actuators are C1, B1, in, out, lift; did you mean 'in'?");
  EXPECT_EQ(found.items()[1].hint,
            "declare one under 'actuators:', for example c_drive: {coupling: c}");
}

TEST(ShiftCheck, RefusesElementsNamedTwice) {
  EXPECT_EQ(complaints_about("shift: {input: in, output: out, elements: [C1, B1, C1]}\n"),
            (Complaints{"30:52 E0307 'elements' of 'shift' names 'C1' twice"}));
}

TEST(ShiftCheck, RefusesAnActuatorInTwoRoles) {
  EXPECT_EQ(complaints_about("shift: {input: in, output: [out, in], elements: [C1, out]}\n"),
            (Complaints{"30:34 E0305 'in' cannot be both input and output",
                        "30:54 E0305 'out' cannot be both output and shift element"}));
}

TEST(ShiftCheck, WantsQuantitiesOfTheInput) {
  EXPECT_EQ(complaints_about(kShift + "  input_motion: 1 mm/s\n  input_action: 5 N\n"),
            (Complaints{"34:17 E0309 expected an angular velocity, found a velocity",
                        "35:17 E0309 expected a moment, found a force"}));
  EXPECT_EQ(complaints_about(
                "shift: {input: lift, output: out, elements: [C1], input_motion: 1 rad/s}\n"),
            (Complaints{"30:65 E0309 expected a velocity, found an angular velocity"}));
}

TEST(ShiftCheck, WantsAValueForEachWhereInputsTurnAndSlide) {
  EXPECT_EQ(complaints_about(
                "shift: {input: [in, lift], output: out, elements: [C1], input_motion: 1}\n"),
            (Complaints{"30:71 E0309 'input_motion' is one value for inputs that turn and slide"}));
}

TEST(ShiftCheck, RefusesAnInputThatDoesNothing) {
  EXPECT_EQ(complaints_about(kShift + "  input_motion: {in: 0}\n  input_action: T - T\n"),
            (Complaints{"34:22 E0305 'input_motion' cannot be 0",
                        "35:17 E0305 'input_action' cannot be T - T = 0 N*m"}));
}

TEST(ShiftCheck, RefusesAValueForWhatIsNoInput) {
  EXPECT_EQ(
      complaints_about(kShift + "  input_motion: {out: 1}\n"),
      (Complaints{"34:18 E0313 'input_motion' names 'out', which is not an input of 'shift'"}));
}

TEST(ShiftCheck, WantsLabelsOfElements) {
  const Diagnostics found = check_of(gear_set(kShift + "  names: {G1: [C1, B2], G2: [C1, C1]}\n"));

  EXPECT_EQ(complaints_of(found),
            (Complaints{"34:20 E0313 gear 'G1' engages 'B2', which is not in 'elements'",
                        "34:34 E0307 gear 'G2' names 'C1' twice"}));
  EXPECT_EQ(found.items()[0].hint, "elements are C1, B1; did you mean 'B1'?");
}

TEST(ShiftCheck, RefusesTwoLabelsOfOneCombination) {
  EXPECT_EQ(complaints_about(kShift + "  names: {G1: [C1, B1], G2: [B1, C1]}\n"),
            (Complaints{"34:25 E0307 gear 'G2' engages the same elements as 'G1'"}));
}

TEST(ShiftCheck, RefusesTheLabelOfACase) {
  EXPECT_EQ(complaints_about(kShift + "  names: {low: [C1, B1]}\n"),
            (Complaints{"34:11 E0307 gear 'low' has the label of a case"}));
}

}  // namespace
}  // namespace kinestat
