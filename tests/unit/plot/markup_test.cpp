#include "draw/markup.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/contract.hpp"

namespace kinestat {
namespace {

TEST(Markup, EscapesWhatEndsTextsTagsAndAttributes) {
  EXPECT_EQ(escape_markup("<script>alert('x')</script>"),
            "&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;");
  EXPECT_EQ(escape_markup("]]>"), "]]&gt;");
  EXPECT_EQ(escape_markup("a \"b\" & c"), "a &quot;b&quot; &amp; c");
  EXPECT_EQ(escape_markup("&lt;"), "&amp;lt;");
}

TEST(Markup, KeepsTextOfOtherAlphabets) {
  EXPECT_EQ(escape_markup("Übertragung ω 齿轮 😀"), "Übertragung ω 齿轮 😀");
}

TEST(Markup, ReplacesControlCharacters) {
  EXPECT_EQ(escape_markup(std::string("a\0b\x1b[31m\x7f", 9)), "a\uFFFDb\uFFFD[31m\uFFFD");
  EXPECT_EQ(escape_markup("\xC2\x9F"), "\uFFFD");
  EXPECT_EQ(escape_markup("\uFFFE\uFFFF"), "\uFFFD\uFFFD");
}

TEST(Markup, PutsLineEndsAndTabsAsSpaces) {
  EXPECT_EQ(escape_markup("a\tb\nc"), "a b c");
}

// A byte that begins none, one that is cut off, overlong forms, a surrogate, too large a number:
// one mark a byte, as the Unicode standard allows (section 3.9).
TEST(Markup, ReplacesBytesThatAreNoCharacters) {
  EXPECT_EQ(escape_markup("\x80"), "\uFFFD");
  EXPECT_EQ(escape_markup("a\xE2\x82"), "a\uFFFD\uFFFD");
  EXPECT_EQ(escape_markup("\xC0\xBC"), "\uFFFD\uFFFD");
  EXPECT_EQ(escape_markup("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(escape_markup("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(escape_markup("\xE0\x80\xBC"), "\uFFFD\uFFFD\uFFFD");
}

TEST(Markup, WritesCoordinatesShortly) {
  EXPECT_EQ(format_coordinate(12.5), "12.5");
  EXPECT_EQ(format_coordinate(100.0), "100");
  EXPECT_EQ(format_coordinate(1.0 / 3.0), "0.33");
  EXPECT_EQ(format_coordinate(-0.004), "0");
  EXPECT_EQ(format_coordinate(-2.999), "-3");
  EXPECT_EQ(format_coordinate(-0.07), "-0.07");
  EXPECT_EQ(format_coordinate(1234567.891), "1234567.89");
}

TEST(Markup, HasNoCoordinateThatIsNotFinite) {
  EXPECT_THROW(format_coordinate(std::numeric_limits<double>::quiet_NaN()), ContractViolation);
  EXPECT_THROW(format_coordinate(std::numeric_limits<double>::infinity()), ContractViolation);
  EXPECT_THROW(format_coordinate(1e300), ContractViolation);
}

}  // namespace
}  // namespace kinestat
