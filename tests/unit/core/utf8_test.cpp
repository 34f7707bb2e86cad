#include "core/utf8.hpp"

#include <string>

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// Code points by their category in UnicodeData.txt, U+3164 by DerivedCoreProperties.txt.
TEST(Printable, ShowsTheBytesOfWhatCannotBeSeen) {
  EXPECT_EQ(printable("a\u061Cb"), "a\\xD8\\x9Cb");                // Cf, turns what follows
  EXPECT_EQ(printable("a\u180Eb"), "a\\xE1\\xA0\\x8Eb");           // Cf
  EXPECT_EQ(printable("a\u202Eb"), "a\\xE2\\x80\\xAEb");           // Cf
  EXPECT_EQ(printable("a\uFFF9b"), "a\\xEF\\xBF\\xB9b");           // Cf
  EXPECT_EQ(printable("a\U000E0041b"), "a\\xF3\\xA0\\x81\\x81b");  // Cf, a letter as a tag
  EXPECT_EQ(printable("a\u00A0b"), "a\\xC2\\xA0b");                // Zs
  EXPECT_EQ(printable("a\u3000b"), "a\\xE3\\x80\\x80b");           // Zs
  EXPECT_EQ(printable("a\u2028b"), "a\\xE2\\x80\\xA8b");           // Zl
  EXPECT_EQ(printable("a\u3164b"), "a\\xE3\\x85\\xA4b");           // a letter that fills a place
}

TEST(Printable, LeavesLettersMarksAndSignsOfAnyScript) {
  for (const char* text : {"é", "e\u0301", "日本", "क्षि", "α_1 ≤ 90°", "😀", "⚙\uFE0F"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(ForeignCharacter, IsNamedAloneWhereItCannotBeSeen) {
  EXPECT_EQ(foreign_character("a\u061Cb"), "U+061C");
  EXPECT_EQ(foreign_character("a\u3000b"), "U+3000");
  EXPECT_EQ(foreign_character("a\u0430"), "'а' (U+0430)");
}

}  // namespace
}  // namespace kinestat
