#include "studies/compare/compare.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "report_texts.hpp"
#include "studies/compare/compare_report.hpp"

namespace kinestat {
namespace {

ReportValues values_of(const std::string& text) {
  Diagnostics found;
  SourceFile source{.path = "r", .text = text};
  auto values = read_report(source, found);
  EXPECT_TRUE(values.has_value()) << text;
  return values ? *std::move(values) : ReportValues(ReportForm::json);
}

// "type place", one a difference.
std::vector<std::string> differences(const std::string& a, const std::string& b) {
  std::vector<std::string> found;
  for (const Difference& one : compare(values_of(a), values_of(b), {}).differences) {
    found.push_back(std::string(word_of(one.type)) + " " + one.place);
  }
  return found;
}

std::string with_case(const std::string& text) {
  return json_report(R"(, "cases": {"M1": )" + text + "}");
}

std::string with_action(const std::string& unit, const std::string& value) {
  return csv_report("c,M1,statics,a.Tz,action," + value + "," + unit + ",solved\n");
}

using List = std::vector<std::string>;

TEST(Compare, FindsNothingInEqualReports) {
  const ReportComparison result = compare(
      values_of(with_case(R"({"ratio": 2.0})")), values_of(with_case(R"({"ratio": 2.0})")), {});

  EXPECT_EQ(result.differences.size(), 0U);
  EXPECT_EQ(result.value_count, 4U);
}

TEST(Compare, SaysByHowMuchNumbersDiffer) {
  const ReportComparison result = compare(
      values_of(with_case(R"({"ratio": 2.0})")), values_of(with_case(R"({"ratio": 2.5})")), {});

  ASSERT_EQ(result.differences.size(), 1U);
  EXPECT_EQ(result.differences[0].amount, 0.5);
  EXPECT_DOUBLE_EQ(result.differences[0].allowed, 2.5e-9);
}

TEST(Compare, FindsPlacesInAnyOrder) {
  const std::string a = R"({"ratio": 2.0, "efficiency": 0.5, "torque_ratio": 1.0})";

  EXPECT_EQ(differences(
                with_case(a),
                with_case(R"({"torque_ratio": 1.0, "efficiency": 0.5, "ratio": 3.0, "rank": 1})")),
            (List{"number /cases/M1/ratio", "only in B /cases/M1/rank"}));
  EXPECT_EQ(differences(with_case(a), with_case(R"({"torque_ratio": 1.0, "ratio": 2.0})")),
            List{"only in A /cases/M1/efficiency"});
}

TEST(Compare, OfTwoColumnsWithOneNameTakesTheFirst) {
  const auto motion = [](const std::string& row) {
    return json_report(R"(, "motion": {"columns": [{"name": "t"}, {"name": "t"}], "rows": [)" +
                       row + "]}");
  };

  EXPECT_EQ(differences(motion("[1.0, 2.0]"), motion("[1.0, 3.0]")), List{});
  EXPECT_EQ(differences(motion("[1.0, 2.0]"), motion("[2.0, 2.0]")),
            List{"number /motion/rows/0/t"});
}

TEST(Compare, LetsRoundingPass) {
  EXPECT_EQ(differences(with_case(R"({"ratio": 2.0})"), with_case(R"({"ratio": 2.000000001})")),
            List{});
}

TEST(Compare, MeasuresZeroByTheLargestOfItsKindInTheCase) {
  const std::string zero = R"({"statics": {"actions": {"a.Rx": 1000.0, "a.Ry": 0.0}}})";
  const std::string tiny = R"({"statics": {"actions": {"a.Rx": 1000.0, "a.Ry": 1e-10}}})";
  const std::string large = R"({"statics": {"actions": {"a.Rx": 1000.0, "a.Ry": 1e-8}}})";

  EXPECT_EQ(differences(with_case(zero), with_case(tiny)), List{});
  EXPECT_EQ(differences(with_case(zero), with_case(large)),
            List{"number /cases/M1/statics/actions/a.Ry"});
}

TEST(Compare, DoesNotMeasureOneCaseByAnother) {
  const auto report = [](const std::string& small) {
    return json_report(R"(, "cases": {"big": {"statics": {"actions": {"a.Rx": 1e12}}},
                                      "small": {"statics": {"actions": {"a.Rx": )" +
                       small + "}}}}");
  };

  EXPECT_EQ(differences(report("1e-3"), report("2e-3")),
            List{"number /cases/small/statics/actions/a.Rx"});
}

TEST(Compare, DoesNotCareForTheOrderOfKeysAndRows) {
  EXPECT_EQ(differences(with_case(R"({"ratio": 2.0, "torque_ratio": 3.0})"),
                        with_case(R"({"torque_ratio": 3.0, "ratio": 2.0})")),
            List{});
  const std::string one = "c,M1,statics,a.Tz,action,1.0,N*m,solved\n";
  const std::string two = "c,M1,statics,a.Rx,action,2.0,N,solved\n";
  EXPECT_EQ(differences(csv_report(one + two), csv_report(two + one)), List{});
}

TEST(Compare, ConvertsUnits) {
  EXPECT_EQ(differences(with_action("N*m", "2.5"), with_action("N*mm", "2500.0")), List{});
  EXPECT_EQ(differences(with_action("N*m", "2.5"), with_action("N*mm", "2.5")),
            List{"number /c/M1/statics/a.Tz/action"});
}

TEST(Compare, ShowsTheSecondNumberInTheUnitOfTheFirst) {
  const auto a = values_of(with_action("N*m", "2.5"));
  const auto b = values_of(with_action("N*mm", "3000.0"));

  const ReportComparison result = compare(a, b, {});

  ASSERT_EQ(result.differences.size(), 1U);
  EXPECT_EQ(result.differences[0].b->number, 3.0);
  EXPECT_EQ(result.differences[0].unit.text, "N*m");
}

TEST(Compare, SaysWhichUnitsDoNotMeasureTheSame) {
  EXPECT_EQ(differences(with_action("N*m", "2.5"), with_action("N", "2.5")),
            List{"unit /c/M1/statics/a.Tz/action"});
  EXPECT_EQ(differences(with_action("N*m", "2.5"), with_action("", "2.5")),
            List{"unit /c/M1/statics/a.Tz/action"});
}

TEST(Compare, ComparesNumbersOfUntoldUnitOnlyInTheSameUnits) {
  const std::string more = R"(, "cases": {"M1": {"later": 2.0}})";

  EXPECT_EQ(differences(json_report("m", "N*m", more), json_report("m", "N*m", more)), List{});
  EXPECT_EQ(differences(json_report("m", "N*m", more), json_report("mm", "N*m", more)),
            List{"unit /cases/M1/later"});
}

TEST(Compare, TellsTextsApart) {
  EXPECT_EQ(differences(with_case(R"({"statics": {"status": "solved"}})"),
                        with_case(R"({"statics": {"status": "indeterminate"}})")),
            List{"text /cases/M1/statics/status"});
}

TEST(Compare, TellsANumberFromATextAndFromNull) {
  EXPECT_EQ(differences(with_case(R"({"ratio": 2.0})"), with_case(R"({"ratio": "2.0"})")),
            List{"text /cases/M1/ratio"});
  EXPECT_EQ(differences(with_case(R"({"ratio": 2.0})"), with_case(R"({"ratio": null})")),
            List{"no value /cases/M1/ratio"});
  EXPECT_EQ(differences(with_action("N*m", "2.5"), with_action("N*m", "")),
            List{"no value /c/M1/statics/a.Tz/action"});
}

TEST(Compare, TakesTwoNullsForEqual) {
  EXPECT_EQ(differences(with_case(R"({"ratio": null})"), with_case(R"({"ratio": null})")), List{});
}

TEST(Compare, NamesWhatOneReportLacksOnce) {
  const std::string full = R"(, "cases": {"M1": {"ratio": 2.0}, "M2": {"ratio": 2.0, "x": 1}})";
  const std::string less = R"(, "cases": {"M1": {"ratio": 2.0}})";

  EXPECT_EQ(differences(json_report(full), json_report(less)), List{"only in A /cases/M2"});
  EXPECT_EQ(differences(json_report(less), json_report(full)), List{"only in B /cases/M2"});
}

TEST(Compare, CountsWhatOneReportLacks) {
  const auto full = values_of(json_report(R"(, "cases": {"M1": {"ratio": 2.0, "x": {"y": 1}}})"));
  const auto less = values_of(json_report(""));

  const ReportComparison result = compare(full, less, {});

  ASSERT_EQ(result.differences.size(), 1U);
  EXPECT_EQ(result.differences[0].count, 2U);
  EXPECT_EQ(result.value_count, 5U);
}

TEST(Compare, SaysOnceThatOneHasNothingWhereTheOtherHasMuch) {
  const std::string full = R"({"statics": {"couplings": {"a": {"force": [1.0, 2.0, 3.0]}}}})";

  EXPECT_EQ(differences(with_case(full), with_case(R"({"statics": {"couplings": {}}})")),
            List{"no value /cases/M1/statics/couplings"});
  EXPECT_EQ(differences(with_case(R"({"statics": {"couplings": {"a": null}}})"), with_case(full)),
            List{"no value /cases/M1/statics/couplings/a"});
}

TEST(Compare, ComparesDiagnosticsByTheirCodes) {
  const auto report = [](const std::string& codes) {
    return json_report(R"(, "diagnostics": [)" + codes + "]");
  };

  EXPECT_EQ(differences(report(R"({"code": "W0301", "message": "x"})"),
                        report(R"({"code": "W0301", "message": "y"})")),
            List{});
  EXPECT_EQ(differences(report(R"({"code": "W0301"})"), report("")),
            List{"only in A /diagnostics/W0301"});
}

TEST(Compare, HoldsNumbersThatDifferByMoreThanADouble) {
  EXPECT_EQ(differences(with_case(R"({"ratio": 1.7e308})"), with_case(R"({"ratio": -1.7e308})")),
            List{"number /cases/M1/ratio"});
  EXPECT_EQ(differences(with_action("N*mm", "1e307"), with_action("kN*km", "1e307")),
            List{"number /c/M1/statics/a.Tz/action"});
}

}  // namespace
}  // namespace kinestat
