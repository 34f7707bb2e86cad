#include "io/cut_value.hpp"

#include <gtest/gtest.h>

#include "support/read_text.hpp"

namespace kinestat {
namespace {

// What is said about the list under the key 'l' of a mapping.
Reading<bool> cut_in(const std::string& list) {
  return read_text("l: " + list + "\n", [](const YamlNode& root, Diagnostics& found) {
    return report_cut_value(*root.find("l"), found);
  });
}

TEST(CutValue, IsShownWholeWithItsQuotes) {
  const auto reading = cut_in("[3, max(1,  2), 0]");

  ASSERT_EQ(reading.found.items().size(), 1U);
  const Diagnostic& error = reading.found.items().front();
  EXPECT_EQ(error.code, "E0308");
  EXPECT_EQ(error.where, (SourceRange{.line = 1, .column = 8, .length = 10}));
  EXPECT_EQ(error.message, "'max(1, 2)' is cut at its comma, which separates values of the list");
  EXPECT_EQ(error.hint, "put it in quotes: \"max(1, 2)\"");
}

TEST(CutValue, MayHaveSeveralCommasAndParentheses) {
  EXPECT_EQ(cut_in("[2*(min(a, (b), c) + 1) mm]").found.items().front().hint,
            "put it in quotes: \"2*(min(a, (b), c) + 1) mm\"");
}

TEST(CutValue, IsNoneWhereTheParenthesesAreClosedOrNeverCloseAgain) {
  EXPECT_EQ(cut_in("[max(1, 2]").complaints(), Complaints{});
  EXPECT_EQ(cut_in("[1), (2]").complaints(), Complaints{});
  EXPECT_EQ(cut_in("[(1), (2)]").complaints(), Complaints{});
  EXPECT_EQ(cut_in("['max(1', 2)]").complaints(), Complaints{});
  EXPECT_EQ(cut_in("[max(1, [2], 3)]").complaints(), Complaints{});
  EXPECT_EQ(cut_in("[]").complaints(), Complaints{});
}

TEST(CutValue, LeavesItsRestAsAKey) {
  const auto reading =
      read_text("{free: max(1, 2), at: 3}\n", [](const YamlNode& root, Diagnostics&) {
        return std::vector<std::string>{whole_entry(root.entries[0], root.entries[1]),
                                        whole_entry(root.entries[1], root.entries[2])};
      });

  EXPECT_EQ(reading.value, (std::vector<std::string>{"free: \"max(1, 2)\"", ""}));
}

}  // namespace
}  // namespace kinestat
