#include "files/output.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(ReportStem, IsTheNameWithoutFolderAndEnding) {
  EXPECT_EQ(report_stem("mechanisms/planar/four_bar.yaml"), "four_bar");
  EXPECT_EQ(report_stem("four_bar.yml"), "four_bar");
}

TEST(ReportStem, KeepsOtherEndings) {
  EXPECT_EQ(report_stem("four_bar.v2.yaml"), "four_bar.v2");
  EXPECT_EQ(report_stem("notes.txt"), "notes.txt");
}

TEST(ReportStem, RemovesOneEndingOnly) {
  EXPECT_EQ(report_stem("a.yaml.yaml"), "a.yaml");
}

TEST(ReportStem, KeepsANameThatIsAllEnding) {
  EXPECT_EQ(report_stem("folder/.yaml"), ".yaml");
}

TEST(ReportStem, OfStandardInputIsStdin) {
  EXPECT_EQ(report_stem("-"), "stdin");
}

TEST(CheckDistinct, AcceptsDifferentNames) {
  Diagnostics found;

  EXPECT_TRUE(check_distinct({"a/x.yaml", "a/y.yaml", "-"}, found));
  EXPECT_TRUE(found.items().empty());
}

TEST(CheckDistinct, RefusesOneNameInTwoFolders) {
  Diagnostics found;

  EXPECT_FALSE(check_distinct({"a/x.yaml", "b/x.yml"}, found));

  ASSERT_EQ(found.items().size(), 1U);
  EXPECT_EQ(found.items().front().code, "E0101");
  EXPECT_NE(found.items().front().message.find("'a/x.yaml' and 'b/x.yml'"), std::string::npos);
}

TEST(CheckDistinct, RefusesTheSameFileTwice) {
  Diagnostics found;

  EXPECT_FALSE(check_distinct({"x.yaml", "x.yaml"}, found));
}

TEST(CheckDistinct, RefusesAFileThatIsNamedLikeStandardInput) {
  Diagnostics found;

  EXPECT_FALSE(check_distinct({"-", "stdin.yaml"}, found));
}

}  // namespace
}  // namespace kinestat
