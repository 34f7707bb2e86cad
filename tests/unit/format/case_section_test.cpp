#include <gtest/gtest.h>

#include "format/sections/sections.hpp"
#include "support/read_section.hpp"

namespace kinestat {
namespace {

auto cases_of(const std::string& text) {
  return read_form(cases(), "'cases'", text);
}

TEST(CaseSection, ReadsEveryKey) {
  const auto reading = cases_of(
      "design point:\n"
      "  motion: {in: 1 rad/s}\n"
      "  action: {out: 2 N*m, c.Rx: 0}\n"
      "  loads: {wind: {body: rod, couple: 3}}\n"
      "  input: in\n"
      "  output: [out, other]\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const CaseDescription& one = (*reading.value)[0];
  EXPECT_EQ(one.label.text, "design point");
  EXPECT_TRUE(one.asks_motions);
  EXPECT_TRUE(one.asks_actions);
  EXPECT_EQ(one.motions[0].target.text, "in");
  EXPECT_EQ(one.actions[1].target.text, "c.Rx");
  EXPECT_EQ(one.loads[0].body.text, "rod");
  EXPECT_EQ(one.inputs[0].text, "in");
  EXPECT_EQ(one.outputs.size(), 2U);
}

TEST(CaseSection, ReadsACaseOfLoadsAlone) {
  const auto reading = cases_of("rest: {loads: {wind: {body: rod, couple: 3}}}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  EXPECT_FALSE((*reading.value)[0].asks_motions);
  EXPECT_FALSE((*reading.value)[0].asks_actions);
}

TEST(CaseSection, RefusesACaseOfNothing) {
  EXPECT_EQ(cases_of("a: {}\nb: {input: x}\n").complaints(),
            (Complaints{"1:1 E0303 case 'a' names neither motions nor actions",
                        "2:1 E0303 case 'b' names neither motions nor actions"}));
}

TEST(CaseSection, ReportsWrongShapesAtTheirPlaces) {
  EXPECT_EQ(cases_of("a: {motion: [in], loads: {wind: {body: rod}}, inputs: x}\n").complaints(),
            (Complaints{"1:13 E0304 'motion' of case 'a' must be a mapping of names to values",
                        "1:27 E0303 load 'wind' has neither 'force' nor 'couple'",
                        "1:47 E0302 case 'a' has no key 'inputs'"}));
}

}  // namespace
}  // namespace kinestat
