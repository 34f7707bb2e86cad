#include "core/codes.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(Codes, AreSortedAndUnique) {
  const auto codes = all_codes();

  const auto at = std::ranges::adjacent_find(
      codes, [](const Code& a, const Code& b) { return a.code >= b.code; });

  EXPECT_EQ(at, codes.end()) << at->code << " is not below its successor";
}

TEST(Codes, HaveATitleAndAParagraphOfSentences) {
  for (const Code& row : all_codes()) {
    SCOPED_TRACE(row.code);
    EXPECT_FALSE(row.title.empty());
    EXPECT_TRUE(row.paragraph.ends_with('.'));
  }
}

TEST(Codes, AreFoundByTheirName) {
  for (const Code& row : all_codes()) {
    EXPECT_EQ(find_code(row.code), &row) << row.code;
  }
}

TEST(Codes, OfWarningsLeaveTheStatusAlone) {
  for (const Code& row : all_codes()) {
    EXPECT_EQ(row.code.starts_with('W'), row.status == ExitStatus::done) << row.code;
  }
}

TEST(FindCode, IsNullForAnUnknownCode) {
  EXPECT_EQ(find_code("E0300"), nullptr);
}

TEST(FindCode, IsNullBeyondTheLastCode) {
  EXPECT_EQ(find_code("Z9999"), nullptr);
}

TEST(FindCode, IsNullForTheBeginningOfACode) {
  EXPECT_EQ(find_code("E03"), nullptr);
}

TEST(FindCode, GivesTheStatusOfTheCommandLineTwo) {
  EXPECT_EQ(static_cast<int>(find_code("E0101")->status), 2);
}

TEST(FindCode, GivesTheStatusOfAMissedValueOne) {
  EXPECT_EQ(static_cast<int>(find_code("E0901")->status), 1);
}

TEST(FindCode, GivesTheStatusOfACaseWithoutAnswerFive) {
  EXPECT_EQ(static_cast<int>(find_code("E0602")->status), 5);
}

}  // namespace
}  // namespace kinestat
