#include "format/key_table.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "format/sections/sections.hpp"

namespace kinestat {
namespace {

bool has_line(const std::string& text, const std::string& line) {
  return ("\n" + text).find("\n" + line + "\n") != std::string::npos;
}

TEST(KeyTable, SaysFormNeedUsualValueAndExampleAndTheMeaningBelow) {
  const std::string table = key_table("motion");

  EXPECT_TRUE(has_line(table, "  drive   NAME; needed; e.g. drive")) << table;
  EXPECT_TRUE(has_line(table, "          The actuator that drives."));
  EXPECT_TRUE(has_line(table, "  steps   VALUE; default 100; e.g. 360"));
}

TEST(KeyTable, ListsBelowAKeyWhatStandsInItsValue) {
  const std::string table = key_table("motion");

  EXPECT_TRUE(has_line(table, "    body  NAME; needed; e.g. coupler")) << table;
  // The keys of an item of 'drives' are those beside it.
  EXPECT_EQ(table.find("drive   NAME"), table.rfind("drive   NAME"));
}

TEST(KeyTable, NamesEverySectionAndThePagesThatAreKnown) {
  const std::string table = section_table(
      [](std::string_view section) { return section == "sweep" ? "sweeps" : std::string(); });

  for (const FormKey& key : file_sections().shape().keys) {
    EXPECT_NE(("\n" + table).find("\n  " + std::string(key.key) + " "), std::string::npos)
        << key.key;
  }
  EXPECT_NE(table.find("; help sweeps"), std::string::npos);
  EXPECT_NE(table.find("\n  x-"), std::string::npos);
}

}  // namespace
}  // namespace kinestat
