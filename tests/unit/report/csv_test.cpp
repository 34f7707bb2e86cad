#include "report/csv.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

using Cells = std::vector<std::string>;

TEST(CsvLine, SeparatesCellsByCommasAndEndsWithLf) {
  EXPECT_EQ(csv_line(Cells{"a", "b", "c"}), "a,b,c\n");
}

TEST(CsvLine, KeepsEmptyCells) {
  EXPECT_EQ(csv_line(Cells{"", "b", ""}), ",b,\n");
}

TEST(CsvLine, QuotesACellWithAComma) {
  EXPECT_EQ(csv_line(Cells{"sun, ring", "b"}), "\"sun, ring\",b\n");
}

TEST(CsvLine, DoublesAQuoteInsideAQuotedCell) {
  EXPECT_EQ(csv_line(Cells{R"(the "long" planet)"}), "\"the \"\"long\"\" planet\"\n");
}

TEST(CsvLine, QuotesACellWithALineFeed) {
  EXPECT_EQ(csv_line(Cells{"two\nlines", "b"}), "\"two\nlines\",b\n");
}

TEST(CsvLine, QuotesACellWithACarriageReturn) {
  EXPECT_EQ(csv_line(Cells{"a\rb"}), "\"a\rb\"\n");
}

TEST(CsvLine, LeavesSpacesApostrophesAndUmlautsAlone) {
  EXPECT_EQ(csv_line(Cells{" it's ", "Mülheim"}), " it's ,Mülheim\n");
}

}  // namespace
}  // namespace kinestat
