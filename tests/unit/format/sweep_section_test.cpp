#include <gtest/gtest.h>

#include "format/sections/sections.hpp"
#include "support/read_section.hpp"

namespace kinestat {
namespace {

auto sweep_of(const std::string& text) {
  return read_section(sweep_section(), "'sweep'", text);
}

TEST(SweepSection, ReadsTheSmallestSection) {
  const auto reading = sweep_of("vary: {N1: {from: 15, to: 40, step: 1}}\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  ASSERT_EQ(reading.value->vary.size(), 1U);
  EXPECT_EQ(reading.value->vary[0].name.text, "N1");
  EXPECT_EQ(reading.value->vary[0].to->expression.text(), "40");
  EXPECT_TRUE(reading.value->require.empty());
  EXPECT_TRUE(reading.value->cases.empty());
}

TEST(SweepSection, ReadsEveryKey) {
  const auto reading = sweep_of(
      "vary: {N1: {from: 15, to: 40, step: 1}, alpha: {values: [14.5 deg, 20 deg]}, N2: [3, 5]}\n"
      "require: [\"N3 == N1 + 2*N2\", N1 > 3]\n"
      "cases: [M1, M2]\n"
      "report: [ratio, h.Rc]\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  const SweepDescription& sweep = *reading.value;
  EXPECT_EQ(sweep.vary[1].values[1].expression.text(), "20 deg");
  EXPECT_EQ(sweep.vary[2].values.size(), 2U);
  ASSERT_EQ(sweep.require.size(), 2U);
  EXPECT_EQ(sweep.require[0].condition.text(), "N3 == N1 + 2*N2");
  EXPECT_EQ(sweep.cases[1].text, "M2");
  EXPECT_EQ(sweep.report[1].text, "h.Rc");
}

TEST(SweepSection, ReadsASingleConditionAndLabel) {
  const auto reading = sweep_of("vary: {N1: [3]}\nrequire: N1 > 2\ncases: M1\n");

  ASSERT_EQ(reading.complaints(), Complaints{});
  EXPECT_EQ(reading.value->require.size(), 1U);
  EXPECT_EQ(reading.value->cases[0].text, "M1");
}

TEST(SweepSection, NeedsParametersToVary) {
  EXPECT_EQ(sweep_of("cases: M1\n").complaints(),
            (Complaints{"1:1 E0303 'sweep' lacks the key 'vary'"}));
  EXPECT_EQ(sweep_of("vary: [N1]\n").complaints(),
            (Complaints{"1:7 E0304 'vary' of 'sweep' must be a mapping of parameters"}));
  EXPECT_EQ(sweep_of("vary: {}\n").complaints(),
            (Complaints{"1:7 E0304 'vary' of 'sweep' must be a mapping of parameters"}));
}

// A range without a step is for a sample: what lacks one is found where both are known.
TEST(SweepSection, WantsARangeOrValues) {
  EXPECT_EQ(
      sweep_of("vary: {a: {from: 1, to: 2}, b: {values: [1], step: 2}, c: {values: []},\n"
               "       d: 3, e: {form: 1, to: 2, step: 1}}\n")
          .complaints(),
      (Complaints{"1:46 E0302 parameter 'b' of 'vary' cannot have 'step' together with 'values'",
                  "1:68 E0304 the values of parameter 'c' of 'vary' must be a list with "
                  "something in it",
                  "2:11 E0304 the values of parameter 'd' of 'vary' must be a list",
                  "2:18 E0302 parameter 'e' of 'vary' has no key 'form'"}));
}

TEST(SweepSection, MarksTheWrongPartOfACondition) {
  const auto reading = sweep_of("vary: {N1: [3]}\nrequire: [N1 = 3, 'N1 >']\n");

  ASSERT_EQ(reading.found.items().size(), 2U);
  EXPECT_EQ(reading.found.items()[0].code, "E0308");
  EXPECT_EQ(reading.found.items()[0].where, (SourceRange{.line = 2, .column = 14, .length = 1}));
  EXPECT_EQ(reading.found.items()[1].where.line, 2);
}

TEST(SweepSection, SaysThatAConditionWithACommaNeedsQuotes) {
  const auto reading = sweep_of("vary: {N1: [3]}\nrequire: [gcd(N1, 4) == 1]\n");

  ASSERT_EQ(reading.found.items().size(), 1U);
  EXPECT_EQ(reading.found.items()[0].where, (SourceRange{.line = 2, .column = 11, .length = 15}));
  EXPECT_EQ(reading.found.items()[0].hint, "put it in quotes: \"gcd(N1, 4) == 1\"");
}

}  // namespace
}  // namespace kinestat
