#include <gtest/gtest.h>

#include "format/sections/sections.hpp"
#include "support/read_section.hpp"

namespace kinestat {
namespace {

auto shift_of(const std::string& text) {
  return read_section(shift_section(), "'shift'", text);
}

TEST(ShiftSection, ReadsTheSmallestSection) {
  const auto reading = shift_of("input: in\noutput: out\nelements: [C1, B1]\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const ShiftDescription& shift = *reading.value;
  ASSERT_EQ(shift.inputs.size(), 1U);
  EXPECT_EQ(shift.inputs[0].text, "in");
  EXPECT_EQ(shift.outputs[0].text, "out");
  EXPECT_EQ(shift.elements[1].text, "B1");
  EXPECT_TRUE(shift.input_motion.empty());
  EXPECT_TRUE(shift.names.empty());
}

TEST(ShiftSection, ReadsEveryKey) {
  const auto reading = shift_of(
      "input: [in, boost]\n"
      "output: [left, right]\n"
      "elements: [C1, C2, B1]\n"
      "input_motion: 1 rad/s\n"
      "input_action: {in: 100 N*m, boost: T}\n"
      "names: {M1: [C1, B1], Rückwärts: C2}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const ShiftDescription& shift = *reading.value;
  EXPECT_EQ(shift.inputs.size(), 2U);
  ASSERT_EQ(shift.input_motion.size(), 1U);
  EXPECT_FALSE(shift.input_motion[0].target);
  ASSERT_EQ(shift.input_action.size(), 2U);
  EXPECT_EQ(shift.input_action[1].target->text, "boost");
  EXPECT_EQ(shift.input_action[1].value.expression.text(), "T");
  ASSERT_EQ(shift.names.size(), 2U);
  EXPECT_EQ(shift.names[1].label.text, "Rückwärts");
  EXPECT_EQ(shift.names[1].elements[0].text, "C2");
}

TEST(ShiftSection, NeedsInputOutputAndElements) {
  EXPECT_EQ(shift_of("input_motion: 1\n").complaints(),
            (Complaints{"1:1 E0303 'shift' lacks the key 'input'",
                        "1:1 E0303 'shift' lacks the key 'output'",
                        "1:1 E0303 'shift' lacks the key 'elements'"}));
}

TEST(ShiftSection, RefusesEmptyLists) {
  EXPECT_EQ(shift_of("input: []\noutput: out\nelements: []\n").complaints(),
            (Complaints{"1:8 E0304 'input' of 'shift' must be a list with something in it",
                        "3:11 E0304 'elements' of 'shift' must be a list with something in it"}));
}

TEST(ShiftSection, ReportsWrongShapesAtTheirPlaces) {
  EXPECT_EQ(
      shift_of("input: {in: 1}\n"
               "output: out\n"
               "elements: [C1, [C2], {B1: 1}]\n"
               "input_motion: [1]\n"
               "input_action: {in: [1]}\n"
               "names: [M1]\n"
               "name: {M1: [C1]}\n")
          .complaints(),
      (Complaints{"1:8 E0304 'input' of 'shift' is a mapping where a single value is expected",
                  "3:16 E0304 'elements' of 'shift' is a list where a single value is expected",
                  "3:22 E0304 'elements' of 'shift' is a mapping where a single value is "
                  "expected",
                  "4:15 E0304 'input_motion' of 'shift' is a list where a single value is "
                  "expected",
                  "5:20 E0304 'input_action' of 'in' is a list where a single value is "
                  "expected",
                  "6:8 E0304 'names' of 'shift' must be a mapping of labels to elements",
                  "7:1 E0302 'shift' has no key 'name'"}));
}

}  // namespace
}  // namespace kinestat
