#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "io/yaml_tree.hpp"
#include "yaml_text.hpp"

namespace kinestat {
namespace {

// The place of the value of 'a' and the column of its text: "line:column+length column".
class Place : public testing::TestWithParam<YamlCase> {};

TEST_P(Place, IsThatInTheSource) {
  const YamlNode value = value_of(GetParam().text);

  EXPECT_EQ(fmt::format("{} {}", place(value.where), value.text_column), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Of,
    Place,
    testing::Values(YamlCase{"PlainText", "a: N1 + N5\n", "1:4+7 4"},
                    YamlCase{"TextBeforeAComment", "a: 2 mm   # length\n", "1:4+4 4"},
                    YamlCase{"TextInBraces", "{b: 1, a: x y }\n", "1:11+3 11"},
                    YamlCase{"SingleQuotes", "a: 'x y'\n", "1:4+5 5"},
                    YamlCase{"DoubleQuotes", "a: \"x y\" # z\n", "1:4+5 5"},
                    YamlCase{"EmptyQuotes", "a: ''\n", "1:4+2 5"},
                    YamlCase{"DoubledQuote", "a: 'it''s'\n", "1:4+7 0"},
                    YamlCase{"Escape", "a: \"x\\ty\"\n", "1:4+6 0"},
                    YamlCase{"TextBeforeACommentOfOneSpace", "a: one # no\n", "1:4+3 4"},
                    YamlCase{"FoldedText", "a: one  \n  two\n", "1:4+3 0"},
                    YamlCase{"FoldedOnEqualText", "a: x\n\n  x\n", "1:4+1 0"},
                    YamlCase{"FoldedQuotes", "a: 'one\n  two'\n", "1:4+4 0"},
                    YamlCase{"BlockScalar", "a: |-\n  x\n", "1:4+2 0"},
                    YamlCase{"BehindAnAnchor", "a: &x  one\n", "1:8+3 8"},
                    YamlCase{"BehindAnAnchorAndALine", "a: &x # c\n  one\n", "2:3+3 3"},
                    YamlCase{"Alias", "b: &x one\na: *x\n", "1:7+3 7"},
                    YamlCase{"AliasOfABlock", "b: &x\n  c: 1\na: *x\n", "2:3+1 0"},
                    YamlCase{"BlockMapping", "a:\n  b: 1\n", "2:3+1 0"},
                    YamlCase{"BlockList", "a:\n- b\n", "2:1+1 0"},
                    YamlCase{"Braces", "a: {b: 1}\n", "1:4+1 0"},
                    YamlCase{"NullIsItsKey", "b: 1\na:\nc: 2\n", "2:1+1 0"},
                    YamlCase{"WrittenNullIsItsKey", "a: ~\n", "1:1+1 0"},
                    YamlCase{"NullInBracesIsItsKey", "{b: 1, a}\n", "1:8+1 0"},
                    YamlCase{"QuotedKey", "'a' : x\n", "1:7+1 7"},
                    YamlCase{"BehindOtherScripts", "{día: ñandú, a: señor}\n", "1:17+5 17"},
                    YamlCase{"BehindFourByteCharacters", "{😀: 1, a: 2}\n", "1:11+1 11"},
                    YamlCase{"EscapedSurrogates", "{\"a\": \"x\\ud83d\\ude00y\"}\n", "1:7+16 0"},
                    YamlCase{
                        "BehindEscapedSurrogates", "{\"\\ud83d\\ude00\": 1, a: 2}\n", "1:24+1 24"},
                    YamlCase{"BehindAnOrderMark",
                             "\xEF\xBB\xBF"
                             "a: é x\n",
                             "1:4+3 4"},
                    YamlCase{"BehindCarriageReturns", "b: é\r\n\r\na: x y\r\n", "3:4+3 4"},
                    YamlCase{"QuotesBeforeACarriageReturn", "a: 'x\r\n  y'\r\n", "1:4+2 0"}),
    name_of_case);

TEST(Place, OfAKeyIncludesItsQuotes) {
  const YamlNode root = read("x: {é: 1, 'b c': 2}\n");

  const YamlNode& inner = root.entries.at(0).value;
  EXPECT_EQ(place(inner.entries.at(0).key_where), "1:5+1");
  EXPECT_EQ(place(inner.entries.at(1).key_where), "1:11+5");
}

TEST(Place, OfANullItemIsItsTextOrElseTheList) {
  const YamlNode list = value_of("a:\n  - 1\n  - null\n  -\n  - 2\n");

  ASSERT_EQ(list.items.size(), 4U);
  EXPECT_EQ(place(list.items[1].where), "3:5+1");
  EXPECT_EQ(place(list.items[2].where), "2:3+1");
}

TEST(Place, OfItemsOnOneLongLineIsFoundInReasonableTime) {
  std::string text = "a: [";
  for (int i = 0; i < 100000; ++i) {
    text += "é, ";
  }
  text += "last]\n";

  const YamlNode list = value_of(text);

  ASSERT_EQ(list.items.size(), 100001U);
  EXPECT_EQ(place(list.items.back().where), "1:300005+4");
}

}  // namespace
}  // namespace kinestat
