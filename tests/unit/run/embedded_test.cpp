#include "run/embedded.hpp"

#include <gtest/gtest.h>

#include "core/codes.hpp"

namespace kinestat {
namespace {

TEST(EmbeddedExamples, BelongToACodeAndEndTheirLines) {
  for (const EmbeddedText& example : embedded_examples()) {
    SCOPED_TRACE(example.name);
    EXPECT_NE(find_code(example.name), nullptr);
    EXPECT_TRUE(example.text.ends_with('\n'));
  }
}

TEST(EmbeddedExamples, HaveAWrongVersionAndMarksOnEveryLine) {
  for (const EmbeddedText& example : embedded_examples()) {
    SCOPED_TRACE(example.name);
    const std::string text = "\n" + std::string(example.text);
    EXPECT_TRUE(text.find("\n- ") != text.npos || text.find("\n+ ") != text.npos);
    for (std::size_t at = text.find('\n'); at + 1 < text.size(); at = text.find('\n', at + 1)) {
      EXPECT_TRUE(text[at + 1] == '-' || text[at + 1] == '+' || text[at + 1] == ' ') << at;
    }
  }
}

TEST(EmbeddedTexts, AreFoundByTheirName) {
  ASSERT_NE(find_text(embedded_starters(), "four-bar"), nullptr);
  ASSERT_NE(find_text(embedded_topics(), "exit-status"), nullptr);
  EXPECT_EQ(find_text(embedded_topics(), "exit"), nullptr);
}

TEST(EmbeddedTexts, KeepEveryByte) {
  const EmbeddedText* topic = find_text(embedded_topics(), "signs");

  ASSERT_NE(topic, nullptr);
  EXPECT_TRUE(topic->text.starts_with("signs: "));
  EXPECT_TRUE(topic->text.ends_with("\n"));
}

}  // namespace
}  // namespace kinestat
