#include "report/text_blocks.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

TEST(TextBlocks, WrapsLongLinesBelowTheirIndent) {
  const TextBlocks text("  known: a.wz = 1 rad/s, press = 500 N\n");

  EXPECT_EQ(text.text({.width = 24}),
            "  known: a.wz = 1 rad/s,\n"
            "    press = 500 N\n");
}

TEST(TextBlocks, LeavesAWordThatIsTooLongWhole) {
  const TextBlocks text("  mechanisms/transmissions/ravigneaux.yaml: ok\n");

  EXPECT_EQ(text.text({.width = 10}),
            "  mechanisms/transmissions/ravigneaux.yaml:\n"
            "    ok\n");
}

TEST(TextBlocks, CountsWideCharactersTwice) {
  const TextBlocks text("  \u65e5\u672c \u65e5\u672c\n");

  EXPECT_EQ(text.text({.width = 11}), "  \u65e5\u672c \u65e5\u672c\n");
  EXPECT_EQ(text.text({.width = 10}), "  \u65e5\u672c\n    \u65e5\u672c\n");
}

TEST(TextBlocks, KeepsLinesAsTheyAreWithoutAWidth) {
  const std::string line = "  " + std::string(200, 'a') + " b\n\n";

  EXPECT_EQ(TextBlocks(line).text(), line);
}

TEST(TextBlocks, MarksHeadingsWhereThereAreColors) {
  const TextBlocks text("Case one\n  known: nothing\n");

  EXPECT_EQ(text.text({.is_coloured = true}), "\x1b[1mCase one\x1b[0m\n  known: nothing\n");
}

}  // namespace
}  // namespace kinestat
