#include "studies/compare/compare_json.hpp"

#include <string>

#include <gtest/gtest.h>

#include "report_texts.hpp"

namespace kinestat {
namespace {

ReportValues json_values(const std::string& text) {
  Diagnostics found;
  SourceFile source{.path = "r.json", .text = text};
  auto values = read_json_report(source, found);
  EXPECT_TRUE(values.has_value()) << text;
  return values ? *std::move(values) : ReportValues(ReportForm::json);
}

// Code and message of the only complaint, after its place.
std::string json_complaint(const std::string& text) {
  Diagnostics found;
  SourceFile source{.path = "r.json", .text = text};
  EXPECT_FALSE(read_json_report(source, found));
  if (found.items().size() != 1) {
    return "not one message";
  }
  const Diagnostic& one = found.items().front();
  return std::to_string(one.where.line) + ":" + std::to_string(one.where.column) + " " +
         std::string(one.code) + " " + one.message;
}

std::string unit_at(const std::string& place, const ReportValues& values) {
  const KeptValue* value = values.find(place);
  return value == nullptr ? "none"
                          : values.unit_of(*value).kind + " " + values.unit_of(*value).text;
}

TEST(JsonReport, HoldsValuesAtTheirPlaces) {
  const ReportValues values = json_values(json_report(R"(, "cases": {"up/down": {"ratio": 2.5}})"));

  const KeptValue* ratio = values.find("/cases/up~1down/ratio");

  ASSERT_NE(ratio, nullptr);
  EXPECT_EQ(ratio->number, 2.5);
}

TEST(JsonReport, LeavesOutWhatDiffersBetweenTwoRuns) {
  const ReportValues values = json_values(json_report(
      R"(, "cases": {"M1": {"statics": {"evidence": {"rank": 3}},
                             "power": {"balance_residual": 1e-17}}})"));

  ASSERT_EQ(values.items().size(), 3U);
  EXPECT_EQ(values.items()[0].place(), "/mechanism/name");
  EXPECT_EQ(values.items()[1].place(), "/mechanism/space");
  EXPECT_EQ(values.items()[2].place(), "/mechanism/parameters");
}

TEST(JsonReport, KeepsACaseThatIsCalledEvidence) {
  EXPECT_NE(json_values(json_report(R"(, "cases": {"evidence": {"ratio": 1}})"))
                .find("/cases/evidence/ratio"),
            nullptr);
}

TEST(JsonReport, PutsNamedThingsUnderTheirNames) {
  const ReportValues values = json_values(json_report(
      R"(, "graph": {"couplings": [{"name": "b", "at": [1, 2, 0], "bodies": ["f", "c"]}],
                     "tree": ["b", "a"]})"));

  EXPECT_NE(values.find("/graph/couplings/b/at/1"), nullptr);
  EXPECT_NE(values.find("/graph/tree/a"), nullptr);
}

TEST(JsonReport, KeepsThePlaceAboveOnceForNeighbours) {
  const ReportValues values =
      json_values(json_report(R"(, "graph": {"couplings": [{"name": "b", "at": [1, 2, 0]}]})"));

  const char* above = values.find("/graph/couplings/b/at/0")->parent.data();

  EXPECT_EQ(values.find("/graph/couplings/b/at/1")->parent.data(), above);
  EXPECT_EQ(values.find("/graph/couplings/b/at/2")->parent.data(), above);
}

TEST(JsonReport, TakesRowsThatAreNoListForAValue) {
  const ReportValues values = json_values(json_report(R"(, "motion": {"columns": [], "rows": 5})"));

  ASSERT_NE(values.find("/motion/rows"), nullptr);
  EXPECT_EQ(values.find("/motion/rows")->number, 5.0);
}

TEST(JsonReport, KeepsTheOrderOfTailAndHead) {
  const ReportValues values = json_values(
      json_report(R"(, "graph": {"couplings": [{"name": "b", "bodies": ["f", "c"]}]})"));

  ASSERT_NE(values.find("/graph/couplings/b/bodies/0"), nullptr);
  EXPECT_EQ(values.find("/graph/couplings/b/bodies/0")->text, "f");
}

TEST(JsonReport, NumbersAListWhoseNamesAreNotUnique) {
  EXPECT_NE(json_values(json_report(R"(, "graph": {"tree": ["a", "a"]})")).find("/graph/tree/1"),
            nullptr);
}

TEST(JsonReport, CountsTheCodesOfDiagnostics) {
  const ReportValues values = json_values(
      json_report(R"(, "diagnostics": [{"code": "W0301", "message": "x"}, {"code": "W0301"}])"));

  ASSERT_NE(values.find("/diagnostics/W0301"), nullptr);
  EXPECT_EQ(values.find("/diagnostics/W0301")->number, 2.0);
}

TEST(JsonReport, KnowsUnitsByPlace) {
  const ReportValues values = json_values(json_report("mm", "N*mm", R"(,
    "mobility": {"planar": {"order": 3}},
    "graph": {"couplings": [
      {"name": "a", "at": [1, 2, 3], "freedoms": ["wz"], "actuators": ["motor"]},
      {"name": "d", "freedoms": ["vx"], "actuators": ["press"]},
      {"name": "e", "freedoms": ["vx", "wz"], "actuators": ["both"]}]},
    "cases": {"M1": {"ratio": 2.0,
      "kinematics": {"freedoms": {"a.wz": 1, "d.vx": 1},
                     "bodies": {"crank": {"twist": [1, 2, 3, 4, 5, 6],
                                          "screw": {"direction": [0, 0, 1], "pitch": 1}}}},
      "statics": {"actions": {"a.Rx": 1, "a.Tz": 1, "motor": 1, "press": 1, "both": 1},
                  "couplings": {"a": {"wrench": [1, 2, 3, 4, 5, 6]}}},
      "power": {"couplings": {"a": 1}, "later": 1}}})"));
  const std::string motions = "/cases/M1/kinematics/";
  const std::string actions = "/cases/M1/statics/actions/";

  EXPECT_EQ(unit_at("/mobility/planar/order", values), "count ");
  EXPECT_EQ(unit_at("/graph/couplings/a/at/0", values), "length mm");
  EXPECT_EQ(unit_at(motions + "freedoms/a.wz", values), "angular_velocity rad/s");
  EXPECT_EQ(unit_at(motions + "freedoms/d.vx", values), "velocity mm/s");
  EXPECT_EQ(unit_at(motions + "bodies/crank/twist/2", values), "angular_velocity rad/s");
  EXPECT_EQ(unit_at(motions + "bodies/crank/twist/3", values), "velocity mm/s");
  EXPECT_EQ(unit_at(motions + "bodies/crank/screw/direction/0", values), "direction ");
  EXPECT_EQ(unit_at(motions + "bodies/crank/screw/pitch", values), "length mm");
  EXPECT_EQ(unit_at(actions + "a.Rx", values), "force N");
  EXPECT_EQ(unit_at(actions + "a.Tz", values), "moment N*mm");
  EXPECT_EQ(unit_at(actions + "motor", values), "moment N*mm");
  EXPECT_EQ(unit_at(actions + "press", values), "force N");
  EXPECT_EQ(unit_at("/cases/M1/statics/couplings/a/wrench/0", values), "moment N*mm");
  EXPECT_EQ(unit_at("/cases/M1/power/couplings/a", values), "power W");
}

TEST(JsonReport, SaysWhereItDoesNotTellTheUnit) {
  const ReportValues values = json_values(json_report(R"(,
    "graph": {"couplings": [{"name": "e", "freedoms": ["vx", "wz"], "actuators": ["both"]}]},
    "cases": {"M1": {"statics": {"actions": {"both": 1}}, "power": {"later": 1}}})"));

  for (const char* place : {"/cases/M1/statics/actions/both", "/cases/M1/power/later"}) {
    ASSERT_NE(values.find(place), nullptr) << place;
    EXPECT_NE(values.unit_of(*values.find(place)).assumes, "") << place;
  }
}

TEST(JsonReport, CountsARatioInTheUnitThatItsCaseNames) {
  const ReportValues values = json_values(json_report(R"json(,
    "cases": {"turns": {"ratio": 2.0},
              "slides": {"ratio": 2.0, "ratio_unit": "rad/s/(mm/s)"},
              "older": {"ratio": 2.0, "ratio_unit": "rad/s per mm/s"}})json"));

  EXPECT_EQ(unit_at("/cases/turns/ratio", values), "ratio ");
  EXPECT_EQ(unit_at("/cases/slides/ratio", values), "ratio rad/mm");
  EXPECT_EQ(unit_at("/cases/older/ratio", values), "ratio rad/mm");
  const ValueUnit& unit = values.unit_of(*values.find("/cases/slides/ratio"));
  EXPECT_EQ(unit.scale.to_si(1.0), 1000.0);  // 1 rad/s per 0.001 m/s
  EXPECT_EQ(unit.assumes, "");
}

TEST(JsonReport, CountsCoefficientsPerUnitOfTheParameter) {
  std::string text = json_report("mm", "N*mm", R"(,
    "cases": {"M1": {"affine": {"a.Tz": {"1": 2.0, "h": 3.0}}}})");
  text.replace(text.find(R"("parameters": {})"),
               std::string(R"("parameters": {})").size(),
               R"("parameters": {"h": {"value": 1, "unit": "mm"}})");
  const ReportValues values = json_values(text);

  EXPECT_EQ(unit_at("/cases/M1/affine/a.Tz/1", values), "moment N*mm");
  EXPECT_EQ(unit_at("/cases/M1/affine/a.Tz/h", values), "moment N");
}

TEST(JsonReport, RefusesWhatIsNoReport) {
  EXPECT_EQ(json_complaint("{}"),
            "0:0 E0903 this is not a report of kinestat: there is no /kinestat/report");
  EXPECT_EQ(json_complaint(R"({"kinestat": {"diagnostics": 1}})"),
            "0:0 E0903 these are messages, not a report");
  EXPECT_EQ(json_complaint(R"({"kinestat": 1})"),
            "0:0 E0903 this is not a report of kinestat: there is no /kinestat/report");
}

TEST(JsonReport, RefusesAnotherVersion) {
  EXPECT_EQ(json_complaint(R"({"kinestat": {"report": 2}})"),
            "0:0 E0904 the report is of version 2 of its format, this program reads 1");
}

TEST(JsonReport, RefusesUnitsThatAreNone) {
  EXPECT_EQ(json_complaint(json_report("ell", "N*m", "")),
            "0:0 E0903 /mechanism/units/length: unknown unit 'ell'");
  EXPECT_EQ(json_complaint(R"({"kinestat": {"report": 1}})"),
            "0:0 E0903 there is no unit at /mechanism/units/length");
}

TEST(JsonReport, RefusesWhatIsNoJson) {
  EXPECT_EQ(json_complaint("{\"a\": [1, ü]}"), "1:11 E0903 this is not JSON from here on");
  EXPECT_EQ(json_complaint("{\"a\": 01}"), "1:7 E0903 this is not JSON from here on");
}

TEST(JsonReport, SaysWhereItWasCutOff) {
  EXPECT_EQ(json_complaint("{\n  \"a\": [1,"), "2:11 E0903 the JSON ends too early");
  EXPECT_EQ(json_complaint(""), "1:1 E0903 the JSON ends too early");
}

TEST(JsonReport, RefusesTokensThatAreNoNumbers) {
  EXPECT_EQ(json_complaint("{\"a\": NaN}"), "1:7 E0903 'NaN' is not JSON");
  EXPECT_EQ(json_complaint("{\"a\": nan}"), "1:7 E0903 'nan' is not JSON");
  EXPECT_EQ(json_complaint("{\"a\": -Infinity}"), "1:7 E0903 '-Infinity' is not JSON");
}

TEST(JsonReport, RefusesANumberBeyondADouble) {
  EXPECT_EQ(json_complaint("{\"a\": 1e999}"), "0:0 E0903 a number is beyond what a double holds");
}

TEST(JsonReport, RefusesASecondReport) {
  EXPECT_EQ(json_complaint("{}\n{}"), "2:1 E0903 there is more after the report");
}

TEST(JsonReport, RefusesAKeyThatIsGivenTwice) {
  EXPECT_EQ(json_complaint(R"({"a": 1, "b": {"a": 1}, "a": 2})"),
            "0:0 E0903 the key 'a' is given twice in one object");
}

TEST(JsonReport, RefusesDeepNestingWithoutStoringIt) {
  EXPECT_EQ(json_complaint("{\"a\":" + std::string(5'000'000, '[')),
            "1:5000006 E0903 the JSON ends too early");
  EXPECT_EQ(json_complaint("{\"a\":" + std::string(100, '[') + std::string(100, ']') +
                           ", \"b\": {\"c\": 1}}"),
            "0:0 E0903 nesting deeper than 64 levels");
}

TEST(JsonReport, RefusesAnObjectWhoseKeysWouldTakeTooLong) {
  std::string text = "{";
  for (int i = 0; i < 30000; ++i) {
    text += "\"" + std::to_string(i) + "\":0,";
  }

  EXPECT_EQ(json_complaint(text + "\"end\":0}"), "0:0 E0903 an object has too many keys");
}

}  // namespace
}  // namespace kinestat
