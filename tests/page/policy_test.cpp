#include <gtest/gtest.h>

#include "pages/html_document.hpp"

namespace kinestat {
namespace {

// By `printf abc | openssl dgst -sha256 -binary | base64`.
constexpr const char* kHashOfAbc = "sha256-ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=";

// Of whatever part of the script has use for it.
constexpr std::string_view kAllMarks =
    "<figure data-chart=\"a\"><script id=\"a-scene\"></script><div data-poses=\"a\">";

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  EXPECT_NE(from, std::string::npos) << begin;
  const std::size_t to = text.find(end, from);
  return text.substr(from + begin.size(), to - from - begin.size());
}

TEST(ContentPolicy, NamesHashesAndNothingElse) {
  const std::string policy = content_policy("abc", "abc");

  EXPECT_EQ(policy,
            std::string("default-src 'none'; style-src '") + kHashOfAbc + "'; script-src '" +
                kHashOfAbc + "'; img-src data:; base-uri 'none'; form-action 'none'");
}

// A browser takes the text between the tags, byte for byte.
TEST(ContentPolicy, IsThatOfTheStyleAndTheScriptOfThePage) {
  const std::string html = html_report({});
  const std::string style = between(html, "<style>", "</style>");
  const std::string script = between(html, "<script>", "</script>");

  EXPECT_EQ(style, page_style());
  EXPECT_EQ(script, page_script(""));
  std::string escaped;
  for (const char character : content_policy(style, script)) {
    escaped += character == '\'' ? "&#39;" : std::string(1, character);
  }
  EXPECT_NE(html.find("content=\"" + escaped + "\""), std::string::npos);
}

TEST(ContentPolicy, IsNotBrokenByStylesOrHandlersInElements) {
  const std::string html = html_report({});

  EXPECT_EQ(html.find(" style="), std::string::npos);
  EXPECT_EQ(html.find(" onclick="), std::string::npos);
}

TEST(PageStyle, HoldsNoEndOfItself) {
  EXPECT_EQ(page_style().find("</"), std::string::npos);
  EXPECT_EQ(page_script(kAllMarks).find("</"), std::string::npos);
}

TEST(PageScript, HasThePartsThatThePageHasUseFor) {
  const auto has = [](std::string_view script, std::string_view words) {
    return script.find(words) != std::string_view::npos;
  };
  const std::string none = page_script("<p>data-save</p>");
  const std::string moving = page_script("<figure data-poses=\"a\">");

  EXPECT_TRUE(has(none, "data-save"));
  EXPECT_FALSE(has(none, "data-poses"));
  EXPECT_TRUE(has(moving, "data-poses"));
  EXPECT_FALSE(has(moving, "data-chart"));
  EXPECT_GT(page_script(kAllMarks).size(), 2 * none.size());
}

TEST(HtmlReport, BeginsWithItsSignature) {
  EXPECT_TRUE(html_report({}).starts_with(html_signature()));
}

}  // namespace
}  // namespace kinestat
