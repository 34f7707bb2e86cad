#include "studies/compare/compare_csv.hpp"

#include <string>

#include <gtest/gtest.h>

#include "report_texts.hpp"

namespace kinestat {
namespace {

ReportValues csv_values(const std::string& text) {
  Diagnostics found;
  auto values = read_csv_report({.path = "r.csv", .text = text}, found);
  EXPECT_TRUE(values.has_value()) << text;
  return values ? *std::move(values) : ReportValues(ReportForm::csv);
}

std::string csv_complaint(const std::string& text) {
  Diagnostics found;
  EXPECT_FALSE(read_csv_report({.path = "r.csv", .text = text}, found));
  if (found.items().size() != 1) {
    return "not one message";
  }
  const Diagnostic& one = found.items().front();
  return std::to_string(one.where.line) + " " + std::string(one.code) + " " + one.message;
}

TEST(CsvReport, HoldsValueAndStatusOfEachRow) {
  const ReportValues values =
      csv_values(csv_report("Crank,M1,statics,a.Tz,action,2.5,N*mm,solved\n"));

  const KeptValue* value = values.find("/Crank/M1/statics/a.Tz/action");
  const KeptValue* status = values.find("/Crank/M1/statics/a.Tz/action/status");

  ASSERT_NE(value, nullptr);
  EXPECT_EQ(value->number, 2.5);
  EXPECT_EQ(values.unit_of(*value).kind, "moment");
  EXPECT_EQ(values.unit_of(*value).text, "N*mm");
  ASSERT_NE(status, nullptr);
  EXPECT_EQ(status->text, "solved");
}

TEST(CsvReport, TakesAnEmptyCellForNoValue) {
  const ReportValues values = csv_values(csv_report("c,M1,power,,input,,W,solved\n"));

  ASSERT_NE(values.find("/c/M1/power//input"), nullptr);
  EXPECT_EQ(values.find("/c/M1/power//input")->type, ValueType::null);
}

TEST(CsvReport, KnowsCountsByTheirPass) {
  const ReportValues values = csv_values(csv_report("c,,mobility,planar,order,3,,solved\n"));

  EXPECT_EQ(values.unit_of(*values.find("/c//mobility/planar/order")).kind, "count");
}

TEST(CsvReport, ReadsQuotedCells) {
  const ReportValues values =
      csv_values(csv_report("\"a, \"\"b\"\"\nc\",M1,statics,a.Tz,action,2.5,N*m,solved\n"
                            "d,M1,statics,a.Tz,action,2.5,N*m,solved\n"));

  EXPECT_NE(values.find("/a, \"b\"\nc/M1/statics/a.Tz/action"), nullptr);
  EXPECT_NE(values.find("/d/M1/statics/a.Tz/action"), nullptr);
}

TEST(CsvReport, ReadsColumnsInAnyOrder) {
  const ReportValues values = csv_values(
      "value,unit,status,mechanism,case,pass,element,quantity\n"
      "2.5,N,solved,c,M1,statics,a.Rx,action\n");

  EXPECT_EQ(values.find("/c/M1/statics/a.Rx/action")->number, 2.5);
}

TEST(CsvReport, ReadsWhatASpreadsheetWrites) {
  const ReportValues values = csv_values(
      "\xEF\xBB\xBFmechanism,case,pass,element,quantity,value,unit,status\r\n"
      "c,M1,statics,a.Rx,action,2.5,N,solved\r\n\r\n");

  EXPECT_EQ(values.items().size(), 2U);
}

TEST(CsvReport, MayHaveNoRows) {
  EXPECT_TRUE(csv_values(csv_report("")).items().empty());
}

TEST(CsvReport, RefusesAMissingColumn) {
  EXPECT_EQ(csv_complaint("mechanism,case,pass,element,quantity,value,status\n"),
            "1 E0903 the table has no column 'unit'");
}

TEST(CsvReport, RefusesAnUnknownColumn) {
  EXPECT_EQ(csv_complaint("mechanism,case,pass,element,quantity,value,units,status\n"),
            "1 E0903 the table has an unknown column 'units'");
}

TEST(CsvReport, RefusesAColumnGivenTwice) {
  EXPECT_EQ(csv_complaint("mechanism,case,pass,element,quantity,value,unit,status,unit\n"),
            "1 E0903 the table has two columns 'unit'");
}

TEST(CsvReport, RefusesARowOfAnotherLength) {
  EXPECT_EQ(csv_complaint(csv_report("c,M1,statics\n")), "2 E0903 the row has 3 cells, not 8");
}

TEST(CsvReport, RefusesValuesThatAreNoNumbers) {
  for (const char* text : {"nan", "NaN", "inf", "-Infinity", "1e999", "1.5x", " 1", "0x1p3"}) {
    EXPECT_EQ(
        csv_complaint(csv_report("c,M1,statics,a.Rx,action," + std::string(text) + ",N,solved\n")),
        "2 E0903 '" + std::string(text) + "' is not a number");
  }
  EXPECT_EQ(csv_complaint(csv_report("c,M1,statics,a.Rx,action,\"1,5\",N,solved\n")),
            "2 E0903 '1,5' is not a number");
}

TEST(CsvReport, RefusesAUnitThatIsNone) {
  EXPECT_EQ(csv_complaint(csv_report("c,M1,statics,a.Rx,action,1,newton,solved\n")),
            "2 E0903 unknown unit 'newton'");
}

TEST(CsvReport, RefusesTwoRowsWithOneKey) {
  EXPECT_EQ(csv_complaint(csv_report("c,M1,statics,a.Rx,action,1,N,solved\n"
                                     "c,M1,statics,a.Rx,action,2,N,solved\n")),
            "3 E0903 there are two rows for /c/M1/statics/a.Rx/action");
}

TEST(CsvReport, RefusesAQuoteThatIsNotClosed) {
  EXPECT_EQ(csv_complaint(csv_report("\"c,M1,statics,a.Rx,action,1,N,solved\n")),
            "3 E0903 a quote is not closed, or text follows one");
}

TEST(CsvReport, SaysNoMoreThanTwentyThings) {
  std::string rows;
  for (int i = 0; i < 1000; ++i) {
    rows += "c\n";
  }
  Diagnostics found;

  EXPECT_FALSE(read_csv_report({.path = "r.csv", .text = csv_report(rows)}, found));
  EXPECT_EQ(found.error_count(), 20);
}

}  // namespace
}  // namespace kinestat
