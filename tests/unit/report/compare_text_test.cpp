#include "studies/compare/compare_text.hpp"

#include <string>

#include <gtest/gtest.h>

#include "report/json_values.hpp"
#include "report_texts.hpp"
#include "studies/compare/compare_report.hpp"

namespace kinestat {
namespace {

ReportComparison compared(const std::string& a, const std::string& b) {
  Diagnostics found;
  SourceFile first{.path = "a", .text = a};
  SourceFile second{.path = "b", .text = b};
  return compare(*read_report(first, found), *read_report(second, found), {});
}

std::string text_of(const ReportComparison& comparison, std::size_t width = 0) {
  return comparison_blocks(comparison).text({.width = width});
}

std::string report(const std::string& actions) {
  return json_report(R"(, "cases": {"M1": {"statics": {"actions": {)" + actions + "}}}}");
}

TEST(ComparisonText, SaysThatReportsAreEqual) {
  EXPECT_EQ(text_of(compared(json_report(""), json_report(""))), "equal: 3 values\n");
}

TEST(ComparisonText, ShowsNumbersSoThatTheyDiffer) {
  EXPECT_EQ(text_of(compared(report(R"("a.Rx": 2.0)"), report(R"("a.Rx": 2.0000001)"))),
            "Place                           A          B  Difference  Tolerance  Unit\n"
            "/cases/M1/statics/actions/a.Rx  2  2.0000001       1e-07      2e-09     N\n"
            "\n"
            "1 of 4 values differ\n");
}

TEST(ComparisonText, PartsItsTableWhereItIsTooWide) {
  const ReportComparison one = compared(report(R"("a.Rx": 2.0)"), report(R"("a.Rx": 2.0000001)"));

  EXPECT_EQ(text_of(one, 60),
            "Place                           A          B  Difference\n"
            "/cases/M1/statics/actions/a.Rx  2  2.0000001       1e-07\n"
            "\n"
            "Place                           Tolerance  Unit\n"
            "/cases/M1/statics/actions/a.Rx      2e-09     N\n"
            "\n"
            "1 of 4 values differ\n");
}

TEST(ComparisonText, NamesTheWorstOfSeveral) {
  const std::string text = text_of(
      compared(report(R"("a.Rx": 2.0, "a.Ry": 2.0)"), report(R"("a.Rx": 2.1, "a.Ry": 3.0)")));

  EXPECT_NE(text.find("2 of 5 values differ; furthest from its tolerance is "
                      "/cases/M1/statics/actions/a.Ry\n"),
            std::string::npos)
      << text;
}

TEST(ComparisonText, ShowsFiftyPlaces) {
  std::string a;
  std::string b;
  for (int i = 0; i < 60; ++i) {
    a += (i == 0 ? "\"a" : ",\"a") + std::to_string(i) + ".Rx\": 1.0";
    b += (i == 0 ? "\"a" : ",\"a") + std::to_string(i) + ".Rx\": 2.0";
  }

  const std::string text = text_of(compared(report(a), report(b)));

  EXPECT_NE(text.find("and 10 more places; --format json lists all\n\n60 of 63 values differ"),
            std::string::npos)
      << text;
}

TEST(ComparisonText, ShortensLongTextsBetweenCharacters) {
  const std::string text =
      text_of(compared(json_report(R"(, "note": ")" + std::string(39, 'x') + "üü\""),
                       json_report(R"(, "note": "y")")));

  EXPECT_NE(text.find("'" + std::string(39, 'x') + "…'"), std::string::npos) << text;
}

TEST(ComparisonJson, HoldsNumbersAsNumbers) {
  const Json json = Json::parse(comparison_json(
      compared(report(R"("a.Rx": 2.0)"), report(R"("a.Rx": 3.0)")), "old.json", "new.json"));

  EXPECT_EQ(json["status"], "different");
  EXPECT_EQ(json["a"], "old.json");
  EXPECT_EQ(json["values"], 4);
  EXPECT_EQ(json["differences"][0]["place"], "/cases/M1/statics/actions/a.Rx");
  EXPECT_EQ(json["differences"][0]["b"], 3.0);
  EXPECT_EQ(json["differences"][0]["kind"], "force");
  EXPECT_EQ(json["differences"][0]["unit"], "N");
}

TEST(ComparisonJson, IsValidWhateverTheTextsAre) {
  const std::string a = csv_report("\xFF\x80,M1,statics,a.Rx,action,1.0,N,\xFF\n");
  const std::string b = csv_report("\xFF\x80,M1,statics,a.Rx,action,1.0,N,solved\n");

  const Json json = Json::parse(comparison_json(compared(a, b), "\xFF", "b"));

  EXPECT_EQ(json["a"], "\\xFF");
  EXPECT_EQ(json["differences"][0]["a"], "\\xFF");
}

}  // namespace
}  // namespace kinestat
