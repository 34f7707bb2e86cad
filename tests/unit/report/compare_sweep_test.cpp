#include "studies/compare/compare_sweep.hpp"

#include <string>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

ReportValues row_values(const std::string& text) {
  Diagnostics found;
  auto values = read_sweep_rows({.path = "rows", .text = text}, found);
  EXPECT_TRUE(values.has_value()) << text;
  return values ? *std::move(values) : ReportValues(ReportForm::csv);
}

std::string row_complaint(const std::string& text) {
  Diagnostics found;
  EXPECT_FALSE(read_sweep_rows({.path = "rows", .text = text}, found));
  if (found.items().size() != 1) {
    return "not one message";
  }
  const Diagnostic& one = found.items().front();
  return std::to_string(one.where.line) + " " + std::string(one.code) + " " + one.message;
}

TEST(SweepRows, StandAtWhatIsVariedInSi) {
  const ReportValues values = row_values(
      "L [mm],N,case,F [N],status\n"
      "20,31,up,2.5,solved\n");

  const KeptValue* force = values.find("/L = 0.02 m, N = 31/up/F");
  const KeptValue* status = values.find("/L = 0.02 m, N = 31/up/status");

  ASSERT_NE(force, nullptr);
  EXPECT_EQ(force->number, 2.5);
  EXPECT_EQ(values.unit_of(*force).kind, "force");
  ASSERT_NE(status, nullptr);
  EXPECT_EQ(status->text, "solved");
}

TEST(SweepRows, AreTheSameAsObjectsOnLines) {
  const ReportValues values = row_values(
      "{\"L [m]\":0.02,\"N\":31,\"case\":\"up\",\"F [N]\":2.5,\"status\":\"solved\"}\n"
      "{\"L [m]\":0.03,\"N\":31,\"case\":\"up\",\"F [N]\":null,\"status\":\"locked\"}\n");

  ASSERT_NE(values.find("/L = 0.02 m, N = 31/up/F"), nullptr);
  EXPECT_EQ(values.find("/L = 0.02 m, N = 31/up/F")->number, 2.5);
  ASSERT_NE(values.find("/L = 0.03 m, N = 31/up/F"), nullptr);
  EXPECT_EQ(values.find("/L = 0.03 m, N = 31/up/F")->type, ValueType::null);
}

TEST(SweepRows, AreToldFromReports) {
  EXPECT_TRUE(begins_with_rows("L [mm],case,F [N],status\n"));
  EXPECT_TRUE(begins_with_rows("{\"L\":1.0,\"case\":\"up\",\"status\":\"solved\"}\n"));
  EXPECT_FALSE(begins_with_rows("{\n  \"kinestat\": {}\n}\n"));
  EXPECT_FALSE(begins_with_rows("{\"kinestat\":{\"report\":1},\"status\":\"\"}\n"));
  EXPECT_FALSE(begins_with_rows("mechanism,case,pass,element,quantity,value,unit,status\n"));
}

TEST(SweepRows, AreRefusedWithTheirLine) {
  EXPECT_EQ(row_complaint("L,case,F,status\n1,up,2.5,solved\n2,up,solved\n"),
            "3 E0903 the row has 3 cells, not 4");
  EXPECT_EQ(row_complaint("L,case,F,status\n1,up,nan,solved\n"), "2 E0903 'nan' is not a number");
  EXPECT_EQ(row_complaint("L,case,F [x],status\n").substr(0, 24), "1 E0903 column 'F [x]': ");
  EXPECT_EQ(row_complaint("L,case,F,status\n1,up,2,solved\n1,up,3,solved\n"),
            "3 E0903 there are two rows for /L = 1/up");
  EXPECT_EQ(row_complaint("{\"case\":\"a\",\"status\":\"solved\"}\n{\"case\":\"a\"\n"),
            "2 E0903 the line is not a JSON object");
  EXPECT_EQ(row_complaint("{\"case\":\"a\",\"status\":\"solved\"}\n"
                          "{\"case\":\"b\",\"F\":1,\"status\":\"solved\"}\n"),
            "2 E0903 the row has other keys than those before it");
}

}  // namespace
}  // namespace kinestat
