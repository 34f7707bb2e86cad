#include <gtest/gtest.h>

#include "format/sections/sections.hpp"
#include "support/read_section.hpp"

namespace kinestat {
namespace {

auto parameters_of(const std::string& text) {
  return read_form(parameters(), "'parameters'", text);
}

TEST(ParameterSection, ReadsNumbersExpressionsAndFreeOnes) {
  const auto reading = parameters_of("a: 3\nb: 2*a\nc: {free: 10 mm}\n");

  EXPECT_EQ(reading.complaints(), Complaints{});
  ASSERT_EQ(reading.value->size(), 3U);
  EXPECT_EQ((*reading.value)[1].value.expression.text(), "2*a");
  EXPECT_FALSE((*reading.value)[1].is_free);
  EXPECT_TRUE((*reading.value)[2].is_free);
}

TEST(ParameterSection, SaysWhatAReservedNameIs) {
  EXPECT_EQ(
      parameters_of("m: 1\nmod: 1\nnot: 1\npi: 1\n").complaints(),
      (Complaints{"1:1 E0306 a parameter cannot be named 'm', which is a unit",
                  "2:1 E0306 a parameter cannot be named 'mod', which is a function",
                  "3:1 E0306 a parameter cannot be named 'not', which is a word of conditions",
                  "4:1 E0306 a parameter cannot be named 'pi', which is a constant"}));
}

TEST(ParameterSection, RefusesWhatWouldBeADifference) {
  EXPECT_EQ(parameters_of("a-b: 1\n").complaints(),
            (Complaints{"1:1 E0306 parameter 'a-b' would be read as a difference"}));
}

TEST(ParameterSection, TellsHowToWriteAFunctionOfTwoValuesInBraces) {
  const auto reading = parameters_of("a: {free: max(1, 2)}\n");

  ASSERT_EQ(reading.found.items().size(), 2U);
  EXPECT_EQ(reading.found.items()[0].message, "'(' is not closed");
  EXPECT_EQ(reading.found.items()[1].hint, "put the value in quotes: free: \"max(1, 2)\"");
}

}  // namespace
}  // namespace kinestat
