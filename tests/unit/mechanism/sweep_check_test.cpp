#include <gtest/gtest.h>

#include "mechanism/check/section_checks.hpp"
#include "unit/mechanism/checked_text.hpp"

namespace kinestat {
namespace {

TEST(SweepCheck, AcceptsEveryKey) {
  EXPECT_EQ(
      complaints_about("shift: {input: in, output: out, elements: [C1, B1], names: {G1: C1}}\n"
                       "sweep:\n"
                       "  vary: {N1: {from: 15, to: 40, step: 1}, alpha: {values: [14.5 deg]},\n"
                       "         N2: {from: 9, to: 3, step: -2}, T: [1 N*m, 2 kN*m]}\n"
                       "  require: [N1 > N2, 'gcd(N1, N2) == 1']\n"
                       "  cases: [low, G1, C1+B1]\n"
                       "  report: [ratio, s.wz, in]\n"),
      Complaints{});
}

TEST(SweepCheck, ReportsAParameterThatIsNotDeclared) {
  const Diagnostics found = check_of(gear_set("sweep: {vary: {N9: [1, 2]}}\n"));

  EXPECT_EQ(complaints_of(found),
            (Complaints{"30:16 E0313 'sweep' varies parameter 'N9', which is not declared"}));
  EXPECT_EQ(found.items()[0].hint, "declared parameters are N1, N2, alpha, T; did you mean 'N1'?");
}

TEST(SweepCheck, WantsStepsThatLeadToTheEnd) {
  EXPECT_EQ(complaints_about("sweep:\n"
                             "  vary:\n"
                             "    N1: {from: 15, to: 40, step: -1}\n"
                             "    N2: {from: 15, to: 40, step: 0}\n"),
            (Complaints{"32:34 E0305 the step of 'N1' leads away from 'to'",
                        "33:34 E0305 the step of 'N2' is zero"}));
}

TEST(SweepCheck, WantsValuesThatMeasureWhatTheParameterDoes) {
  const Diagnostics found = check_of(
      gear_set("sweep: {vary: {alpha: [14.5, 20 mm], N1: {from: 1, to: 9 mm, step: 1}}}\n"));

  EXPECT_EQ(
      complaints_of(found),
      (Complaints{"30:24 E0309 parameter 'alpha' is an angle, but this value is a bare number",
                  "30:30 E0309 parameter 'alpha' is an angle, but this value is a length",
                  "30:56 E0309 parameter 'N1' is a bare number, but this value is a length"}));
  EXPECT_EQ(found.items()[0].hint, "write it as under 'parameters:', where it is 20 deg");
}

TEST(SweepCheck, RefusesASweepWithoutEnd) {
  EXPECT_EQ(complaints_about("sweep: {vary: {N1: {from: 0, to: 1e7, step: 1},"
                             " N2: {from: 0, to: 1, step: 1e-6}}}\n"),
            (Complaints{"30:1 E0305 the sweep has 1e+13 states; at most 1e+12 can be run"}));
}

TEST(SweepCheck, MarksWhatIsWrongWithAConditionInIt) {
  EXPECT_EQ(complaints_about("sweep:\n"
                             "  vary: {N1: [1]}\n"
                             "  require: [N1 > N6, alpha == 3, 'N1/0 > 2 and N2 > 3']\n"),
            (Complaints{"32:18 E0311 unknown name 'N6'",
                        "32:22 E0309 an angle and a bare number cannot be compared"}));
}

TEST(SweepCheck, CountsTheNamesOfAConditionAsUsed) {
  Diagnostics found;
  const auto root = read_yaml(
      {.path = "t", .text = gear_set("sweep: {vary: {alpha: [1 deg*N2]}, require: N1 > 3}\n")},
      ReadLimits{},
      found);
  const auto description = read_mechanism(*root, found);
  ASSERT_TRUE(description);
  Evaluator evaluator = make_evaluator(*description, found);

  check_all_sections(*description, evaluator, found);
  evaluator.warn_of_unused();

  EXPECT_EQ(complaints_of(found),
            (Complaints{"4:30 W0301 parameter 'alpha' is never used",
                        "4:45 W0301 parameter 'T' is never used"}));
}

TEST(SweepCheck, ReportsCasesThatAreNotDeclared) {
  EXPECT_EQ(complaints_about("shift: {input: in, output: out, elements: [C1, B1]}\n"
                             "sweep: {vary: {N1: [1]}, cases: [lw, low, C1+B2, C1+, low]}\n"),
            (Complaints{"31:34 E0313 'sweep' runs case or gear 'lw', which is not declared",
                        "31:43 E0313 'sweep' runs case or gear 'C1+B2', which is not declared",
                        "31:50 E0313 'sweep' runs case or gear 'C1+', which is not declared",
                        "31:55 E0307 'cases' of 'sweep' names 'low' twice"}));
}

TEST(SweepCheck, ReportsQuantitiesThatItDoesNotKnow) {
  const Diagnostics found = check_of(gear_set("sweep: {vary: {N1: [1]}, report: [ratoi, q.wz]}\n"));

  EXPECT_EQ(
      complaints_of(found),
      (Complaints{"30:35 E0313 'report' of 'sweep' cannot hold 'ratoi'",
                  "30:42 E0313 'report' of 'sweep' names coupling 'q', which is not declared"}));
}

}  // namespace
}  // namespace kinestat
