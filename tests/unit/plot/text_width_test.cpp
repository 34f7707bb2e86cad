#include "draw/text_width.hpp"

#include <gtest/gtest.h>

namespace kinestat {
namespace {

// Adobe's metrics of Helvetica: H 722, e 556, l 222, o 556 thousandths.
TEST(TextWidth, IsAtLeastThatOfHelvetica) {
  EXPECT_GE(text_width("Hello", 1000.0), 722 + 556 + 222 + 222 + 556);
}

// Advances of DejaVu Sans: W 989, i 278 thousandths.
TEST(TextWidth, IsThatOfTheWidestFont) {
  EXPECT_DOUBLE_EQ(text_width("Wi", 1000.0), 989 + 278);
}

TEST(TextWidth, CountsCharactersAndNotBytes) {
  EXPECT_DOUBLE_EQ(text_width("ωω", 10.0), 2 * text_width("ω", 10.0));
  EXPECT_LE(text_width("é", 10.0), 10.0);
}

TEST(FittingText, LeavesWhatFits) {
  EXPECT_EQ(fitting_text("ring", 12.0, 100.0), "ring");
}

TEST(FittingText, EndsWithDotsAndFits) {
  const std::string text = fitting_text("a very long name of a mechanism", 12.0, 80.0);

  EXPECT_TRUE(text.ends_with("…"));
  EXPECT_LE(text_width(text, 12.0), 80.0);
}

TEST(FittingText, CutsBetweenCharacters) {
  EXPECT_EQ(fitting_text("ωωωω", 10.0, 2.5 * text_width("ω", 10.0)).substr(0, 2), "ω");
}

// Of any width it is the longest beginning that fits.
TEST(FittingText, KeepsAsMuchAsFits) {
  const std::string word = "aωb→c d";
  for (double width = 8.0; width < 60.0; width += 0.5) {
    const std::string text = fitting_text(word, 10.0, width);
    std::string longest = "…";
    for (std::size_t end = 1; end < word.size(); ++end) {
      const bool is_between = (static_cast<unsigned char>(word[end]) & 0xC0U) != 0x80U;
      const std::string cut = word.substr(0, end) + "…";
      longest = is_between && text_width(cut, 10.0) <= width ? cut : longest;
    }
    EXPECT_EQ(text, text_width(word, 10.0) <= width ? word : longest) << width;
  }
}

// Measuring each beginning anew would take 10^12 steps.
TEST(FittingText, OfAMillionLettersIsQuick) {
  const std::string text = fitting_text(std::string(1'000'000, 'a'), 12.0, 80.0);

  EXPECT_EQ(text, fitting_text(std::string(100, 'a'), 12.0, 80.0));
}

TEST(WrappedText, BreaksAtSpaces) {
  const auto lines = wrapped_text("one two three four", 10.0, text_width("one two", 10.0) + 1.0);

  EXPECT_EQ(lines, (std::vector<std::string>{"one two", "three", "four"}));
}

TEST(WrappedText, OfNothingHasNoLine) {
  EXPECT_TRUE(wrapped_text("", 10.0, 100.0).empty());
}

}  // namespace
}  // namespace kinestat
