#include "studies/compare/compare_rows.hpp"

#include <string>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

ReportValues keyed_values(const std::string& text) {
  Diagnostics found;
  auto values = read_keyed_rows({.path = "r.csv", .text = text}, found);
  EXPECT_TRUE(values.has_value()) << text;
  return values ? *std::move(values) : ReportValues(ReportForm::csv);
}

std::string keyed_complaint(const std::string& text) {
  Diagnostics found;
  EXPECT_FALSE(read_keyed_rows({.path = "r.csv", .text = text}, found));
  if (found.items().size() != 1) {
    return "not one message";
  }
  const Diagnostic& one = found.items().front();
  return std::to_string(one.where.line) + " " + std::string(one.code) + " " + one.message;
}

TEST(KeyedRows, AreToldFromOtherTables) {
  EXPECT_TRUE(begins_with_keyed_rows("mechanism,case,status,a.Tz/action [N*m]\n"));
  EXPECT_TRUE(begins_with_keyed_rows("file,mechanism,case,status,step,b.wz/position [deg]\n"));
  EXPECT_TRUE(begins_with_keyed_rows("matrix,row,column,value\n"));
  EXPECT_TRUE(begins_with_keyed_rows("coupling,type,tail,head,part\n"));
  EXPECT_FALSE(begins_with_keyed_rows("mechanism,case,pass,element,quantity,value,unit,status\n"));
  EXPECT_FALSE(begins_with_keyed_rows("mechanism,case,pass,element,value,unit,status\n"));
  EXPECT_FALSE(begins_with_keyed_rows("N,case,ratio,status\n"));
}

TEST(KeyedRows, HaveTheNumbersOfACase) {
  const ReportValues values = keyed_values(
      "mechanism,case,status,ratio,a.Tz/action [N*mm],a.Tz/power [W]\n"
      "Crank,M1,solved,4.2,2.5,\n");

  const KeptValue* action = values.find("/Crank/M1/a.Tz/action");
  ASSERT_NE(action, nullptr);
  EXPECT_EQ(action->number, 2.5);
  EXPECT_EQ(values.unit_of(*action).kind, "moment");
  EXPECT_EQ(values.unit_of(*action).text, "N*mm");
  ASSERT_NE(values.find("/Crank/M1/ratio"), nullptr);
  EXPECT_EQ(values.find("/Crank/M1/ratio")->number, 4.2);
  ASSERT_NE(values.find("/Crank/M1/a.Tz/power"), nullptr);
  EXPECT_EQ(values.find("/Crank/M1/a.Tz/power")->type, ValueType::null);
  ASSERT_NE(values.find("/Crank/M1/status"), nullptr);
  EXPECT_EQ(values.find("/Crank/M1/status")->text, "solved");
}

// Of two files in other units.
TEST(KeyedRows, HaveTheirValueInOneOfTheColumnsOfAName) {
  const std::string heads = "file,mechanism,case,status,P/x [m],P/x [mm]\n";
  const ReportValues values =
      keyed_values(heads + "a.yaml,A,M1,solved,2,\nb.yaml,B,M1,solved,,5\nc.yaml,C,M1,solved,,\n");

  EXPECT_EQ(values.unit_of(*values.find("/a.yaml/A/M1/P/x")).text, "m");
  EXPECT_EQ(values.find("/b.yaml/B/M1/P/x")->number, 5.0);
  EXPECT_EQ(values.unit_of(*values.find("/b.yaml/B/M1/P/x")).text, "mm");
  EXPECT_EQ(values.find("/c.yaml/C/M1/P/x")->type, ValueType::null);
  EXPECT_EQ(keyed_complaint(heads + "a.yaml,A,M1,solved,2,2000\n"),
            "2 E0903 there are two rows for /a.yaml/A/M1");
}

TEST(KeyedRows, TellTheStepsOfAMotionFromTheStepsOfGears) {
  const ReportValues motion = keyed_values(
      "mechanism,case,status,step,b.wz/position [deg]\n"
      "Crank,M1,solved,0,1\n"
      "Crank,M1,solved,1,2\n");
  EXPECT_EQ(motion.find("/Crank/M1/step 1/b.wz/position")->number, 2.0);

  const ReportValues gears = keyed_values(
      "mechanism,case,status,ratio,step\n"
      "Box,1,gear,4,\n"
      "Box,2,gear,2,2\n");
  ASSERT_NE(gears.find("/Box/2/step"), nullptr);
  EXPECT_EQ(gears.find("/Box/2/step")->number, 2.0);
}

// A body may be called as what is not compared; what is of it counts.
TEST(KeyedRows, LeaveOutWhatIsNotCompared) {
  const ReportValues values = keyed_values(
      "mechanism,case,status,closure_error,closure_error/velocity [m/s]\n"
      "Crank,M1,solved,1e-12,3\n");

  EXPECT_EQ(values.find("/Crank/M1/closure_error"), nullptr);
  EXPECT_NE(values.find("/Crank/M1/closure_error/velocity"), nullptr);
}

TEST(KeyedRows, HaveTheEntriesOfAMatrix) {
  const ReportValues values = keyed_values(
      "file,matrix,row,column,value\n"
      "a.yaml,M_N,f/wz,b,-0.5\n");

  ASSERT_NE(values.find("/a.yaml/M_N/f~1wz/b/value"), nullptr);
  EXPECT_EQ(values.find("/a.yaml/M_N/f~1wz/b/value")->number, -0.5);
}

TEST(KeyedRows, HaveTheWordsOfACoupling) {
  const ReportValues values = keyed_values(
      "coupling,type,tail,head,part\n"
      "a,revolute,frame,crank,branch\n");

  ASSERT_NE(values.find("/a/head"), nullptr);
  EXPECT_EQ(values.find("/a/head")->text, "crank");
}

TEST(KeyedRows, SayWhatIsWrong) {
  EXPECT_EQ(keyed_complaint("coupling,type,tail,head,part\na,b,c,d,e\na,b,c,d,e\n"),
            "3 E0903 there are two rows for /a");
  EXPECT_EQ(keyed_complaint("matrix,row,column,value\nQ,a,b\n"),
            "2 E0903 the row has 3 cells, not 4");
  EXPECT_EQ(keyed_complaint("matrix,row,column,value\nQ,a,b,c\n"), "2 E0903 'c' is not a number");
  EXPECT_EQ(keyed_complaint("mechanism,case,status,status\n"),
            "1 E0903 the table has two columns 'status'");
  EXPECT_EQ(keyed_complaint("mechanism,case,status,a/x [furlong]\nc,d,e,1\n").substr(0, 31),
            "1 E0903 column 'a/x [furlong]':");
}

}  // namespace
}  // namespace kinestat
