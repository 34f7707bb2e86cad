#include "io/yaml_tree.hpp"

#include <string>

#include <gtest/gtest.h>

#include "yaml_text.hpp"

namespace kinestat {
namespace {

// All of a tree but its places, in one line.
std::string shape(const YamlNode& node) {
  std::string result;
  switch (node.kind) {
    case YamlKind::null:
      return "~";
    case YamlKind::scalar:
      return node.quoted ? "'" + node.text + "'" : node.text;
    case YamlKind::sequence:
      for (const YamlNode& item : node.items) {
        result += (result.empty() ? "" : ", ") + shape(item);
      }
      return "[" + result + "]";
    case YamlKind::mapping:
      for (const YamlEntry& entry : node.entries) {
        result += (result.empty() ? "" : ", ") + entry.key + ": " + shape(entry.value);
      }
      return "{" + result + "}";
  }
  return result;
}

class YamlShape : public testing::TestWithParam<YamlCase> {};

TEST_P(YamlShape, IsThatOfTheText) {
  EXPECT_EQ(shape(read(GetParam().text)), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Collections,
    YamlShape,
    testing::Values(
        YamlCase{"OrderOfTheFile", "b: 1\na: 2\n", "{b: 1, a: 2}"},
        YamlCase{
            "BlockInBlock", "a:\n  b:\n  - 1\n  - c: 2\n    d: 3\n", "{a: {b: [1, {c: 2, d: 3}]}}"},
        YamlCase{"Brackets", "a: {b: [1, [2], {}], c: []}\n", "{a: {b: [1, [2], {}], c: []}}"},
        YamlCase{"BracketsOverLines", "a: [1,\n 2,\n]\nb: 3\n", "{a: [1, 2], b: 3}"},
        YamlCase{"PairInAList", "a: [b: 1]\n", "{a: [{b: 1}]}"},
        YamlCase{"KeyWithoutValueInBraces", "a: {b, c: 1}\n", "{a: {b: ~, c: 1}}"},
        YamlCase{"ExplicitKey", "? a\n: 1\n? b\n", "{a: 1, b: ~}"},
        YamlCase{"Json", "{\"a\":[1,\"b\"],\"c\":{\"d\":null}}", "{a: [1, 'b'], c: {d: ~}}"},
        YamlCase{"JsonWithSurrogates",
                 "{\"\\uD83D\\uDE00\": \"a\\ud83d\\ude00\\ud83d\\ude01 \\\\ud83d\\\\ude00\"}",
                 "{😀: 'a😀😁 \\ud83d\\ude00'}"},
        YamlCase{"SurrogatesInOtherQuotes", "a: '\\ud83d\\ude00'\n", "{a: '\\ud83d\\ude00'}"},
        YamlCase{"JsonIndentedByTabs", "{\n\t\"a\": 1\n}\n", "{a: 1}"},
        YamlCase{"DocumentMarks", "%YAML 1.2\n---\na: 1\n...\n", "{a: 1}"}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Scalars,
    YamlShape,
    testing::Values(
        YamlCase{"Nulls", "a:\nb: ~\nc: null\nd: [~, null]\n", "{a: ~, b: ~, c: ~, d: [~, ~]}"},
        YamlCase{"EmptyItem", "a:\n-\n- 1\n", "{a: [~, 1]}"},
        YamlCase{
            "Quoted", "a: 'it''s'\nb: \"x\\ty\"\n'c d': ''\n", "{a: 'it's', b: 'x\ty', c d: ''}"},
        YamlCase{"NumbersStayText", "a: 010\nb: 1e400\nc: no\n", "{a: 010, b: 1e400, c: no}"},
        YamlCase{"QuotedNull", "a: '~'\nb: \"\"\n", "{a: '~', b: ''}"},
        YamlCase{"Folded", "a: one\n  two\nb: \"one\n  two\"\n", "{a: one two, b: 'one two'}"},
        YamlCase{"Block", "a: |\n  x: [\n  'y\nb: >-\n  p\n  q\n", "{a: 'x: [\n'y\n', b: 'p q'}"},
        YamlCase{"QuotedMergeKey", "'<<': 1\n", "{<<: 1}"},
        YamlCase{"MarksInsidePlainText",
                 "a: it's [x] {y} 'z # no\nb: x#y\nc: -1\nd: a,b\n",
                 "{a: it's [x] {y} 'z, b: x#y, c: -1, d: a,b}"},
        YamlCase{"ContinuedPlainTextWithMarks", "a: x\n  'y [\n  } z\n", "{a: x 'y [ } z}"},
        YamlCase{"Comments", "# [ { '\na: 1 # ] } \"\n# end", "{a: 1}"},
        YamlCase{"CommentBehindBracket", "a: [1] # it's\n", "{a: [1]}"}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Aliases,
    YamlShape,
    testing::Values(YamlCase{"OfAScalar", "a: &x 1\nb: *x\n", "{a: 1, b: 1}"},
                    YamlCase{"OfAMapping",
                             "a: &x {b: [1]}\nc: [*x, *x]\n",
                             "{a: {b: [1]}, c: [{b: [1]}, {b: [1]}]}"},
                    YamlCase{"OfABlock", "a: &x\n  b: 1\nc: *x\n", "{a: {b: 1}, c: {b: 1}}"},
                    YamlCase{"OfANull", "a: &x\nb: *x\n", "{a: ~, b: ~}"},
                    YamlCase{"OfAnAlias", "a: &x 1\nb: &y [*x]\nc: *y\n", "{a: 1, b: [1], c: [1]}"},
                    YamlCase{"AnchorUsedAnew", "a: &x 1\nb: &x 2\nc: *x\n", "{a: 1, b: 2, c: 2}"},
                    YamlCase{"AsAKey", "a: &x b\n*x : 1\n", "{a: b, b: 1}"}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Encodings,
    YamlShape,
    testing::Values(YamlCase{"OrderMark",
                             "\xEF\xBB\xBF"
                             "a: 1\n",
                             "{a: 1}"},
                    YamlCase{"CarriageReturns",
                             "a: |\r\n  x\r\n  y\r\nb: [1,\r\n 2]\r\nc: p\r\n  q\r\n",
                             "{a: 'x\ny\n', b: [1, 2], c: p q}"},
                    YamlCase{"NoLineEndAtTheEnd", "a: 1", "{a: 1}"},
                    YamlCase{"OtherScripts", "привет: día\n", "{привет: día}"}),
    name_of_case);

class Refused : public testing::TestWithParam<YamlCase> {};

TEST_P(Refused, NamesCodePlaceAndCause) {
  EXPECT_EQ(complaints(GetParam().text), GetParam().expected + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    Documents,
    Refused,
    testing::Values(
        YamlCase{"Empty", "", "E0205 0:0+0 empty document"},
        YamlCase{"OnlyOrderMark", "\xEF\xBB\xBF", "E0205 0:0+0 empty document"},
        YamlCase{"OnlyComments", "# one\n\n  # two\n", "E0205 0:0+0 empty document"},
        YamlCase{"OnlyADocumentMark", "---\n", "E0205 0:0+0 empty document"},
        YamlCase{"Null", "~\n", "E0205 0:0+0 empty document"},
        YamlCase{"RootIsAList", "- a\n- b\n", "E0304 1:1+1 expected a mapping, found a list"},
        YamlCase{"RootIsAScalar",
                 "\nfour bar\n",
                 "E0304 2:1+8 expected a mapping, found a single value"},
        YamlCase{"TwoDocuments", "a: 1\n---\nb: 2\n", "E0206 2:1+3 a second document begins here"},
        YamlCase{
            "SecondBehindAnEnd", "a: 1\n...\n--- b", "E0206 3:1+3 a second document begins here"},
        YamlCase{"EmptySecond", "a: 1\n---\n", "E0206 2:1+3 a second document begins here"},
        YamlCase{"EmptyFirst", "---\n---\na: 1\n", "E0206 2:1+3 a second document begins here"},
        YamlCase{"BehindTheRoot",
                 "{a: 1} b\n",
                 "E0204 1:8+1 this follows the end of the document (note 1:1+1 the document begins "
                 "here)"},
        YamlCase{"ListThenMapping",
                 "- a\nb: 1\n",
                 "E0204 2:1+1 this follows the end of the document (note 1:1+1 the document begins "
                 "here)"},
        YamlCase{"FirstLineIndented",
                 " a: 1\nb: 2\n",
                 "E0204 2:1+1 this follows the end of the document (note 1:2+1 the document begins "
                 "here)"},
        YamlCase{"BehindItsEnd",
                 "a: 1\n...\nb: 2...\n",
                 "E0204 3:1+1 this follows the end of the document (note 2:1+3 the document ends "
                 "here)"}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Keys,
    Refused,
    testing::Values(
        YamlCase{"TwiceAtTheTop",
                 "name: 1\nb: 2\nname: 3\n",
                 "E0207 3:1+4 key 'name' is given twice (note 1:1+4 first given here)"},
        YamlCase{"TwiceNested",
                 "a:\n  b: 1\n  \"b\": 2\n",
                 "E0207 3:3+3 key 'b' is given twice (note 2:3+1 first given here)"},
        YamlCase{"TwiceInBraces",
                 "a: {é: 1, é: 2}\n",
                 "E0207 1:11+1 key 'é' is given twice (note 1:5+1 first given here)"},
        YamlCase{"ThreeTimes",
                 "a: 1\na: 2\na: 3\n",
                 "E0207 2:1+1 key 'a' is given twice (note 1:1+1 first given here)\n"
                 "E0207 3:1+1 key 'a' is given twice (note 1:1+1 first given here)"},
        YamlCase{
            "Merge", "a: &x {b: 1}\nc:\n  <<: *x\n", "E0208 3:3+2 merge key '<<' is not supported"},
        YamlCase{"List", "[a, b]: 1\n", "E0208 1:1+1 a list or mapping cannot be a key"},
        YamlCase{"Mapping", "a: {{b: 1} : 2}\n", "E0208 1:5+1 a list or mapping cannot be a key"},
        YamlCase{"ExplicitList", "? - a\n: 1\n", "E0208 1:3+1 a list or mapping cannot be a key"},
        YamlCase{"Missing", ": 1\n", "E0208 1:1+1 a key is missing or null"},
        YamlCase{"Null", "a: {~: 1}\n", "E0208 1:5+1 a key is missing or null"},
        YamlCase{"WithoutColon", "a: 1\nkey\n", "E0204 2:1+3 'key' has no ':' behind it"},
        YamlCase{
            "WithoutColonAtTheEnd", "a:\n  b: 1\n  key", "E0204 3:3+3 'key' has no ':' behind it"}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Features,
    Refused,
    testing::Values(
        YamlCase{"PythonTag",
                 "a: !!python/object:os.system x\n",
                 "E0208 1:4+25 tag '!!python/object:os.system' is not supported"},
        YamlCase{"LocalTag", "a: [!x 1]\n", "E0208 1:5+2 tag '!x' is not supported"},
        YamlCase{"TagOfAMapping", "a: !!map\n  b: 1\n", "E0208 1:4+5 tag '!!map' is not supported"},
        YamlCase{
            "TagBehindAnAnchor", "a: &x !!str 1\n", "E0208 1:7+5 tag '!!str' is not supported"},
        YamlCase{"TagWithoutValue", "a: !!str\n", "E0208 1:4+5 tag '!!str' is not supported"},
        YamlCase{"TagWithoutName", "a: ! 1\n", "E0208 1:4+1 tag '!' is not supported"},
        YamlCase{"TagOfAKey", "!x a: 1\n", "E0208 1:1+2 tag '!x' is not supported"},
        YamlCase{
            "UnknownAlias", "a: [*b, 1]\n", "E0209 1:5+2 alias '*b' names no anchor before it"},
        YamlCase{"AliasBeforeItsAnchor",
                 "a: *x\nb: &x 1\n",
                 "E0209 1:4+2 alias '*x' names no anchor before it"},
        YamlCase{"AliasInsideItself",
                 "a: &x [1, *x]\n",
                 "E0209 1:11+2 alias '*x' is inside what it names (note 1:7+1 the anchored value "
                 "begins here)"},
        YamlCase{"AliasOfTheRoot",
                 "&x\na: *x\n",
                 "E0209 2:4+2 alias '*x' is inside what it names (note 2:1+1 the anchored value "
                 "begins here)"}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Brackets,
    Refused,
    testing::Values(
        YamlCase{"OpenList", "a: [1, 2\nb: 3\n", "E0204 1:4+1 '[' is not closed"},
        YamlCase{"OpenMapping", "a:\n  b: {c: 1\n", "E0204 2:6+1 '{' is not closed"},
        YamlCase{"InnermostOpen", "a: [1, {b: [2], c: 3\n", "E0204 1:8+1 '{' is not closed"},
        YamlCase{"Crossed",
                 "a: [1, {b: 2]}\n",
                 "E0204 1:8+1 '{' is not closed (note 1:13+1 ']' stands here)"},
        YamlCase{"OtherBracket",
                 "a: [7, 0}\n",
                 "E0204 1:9+1 '}' cannot close '[' (note 1:4+1 '[' is open since here)"},
        YamlCase{"OneTooManyInside",
                 "a: {b: [7, 0]]}\n",
                 "E0204 1:14+1 ']' cannot close '{' (note 1:4+1 '{' is open since here)"},
        YamlCase{"ClosesNothing", "a: 1\nb: ]\n", "E0204 2:4+1 ']' closes nothing"},
        YamlCase{"OneTooMany", "a: {b: 1}}\n", "E0204 1:10+1 '}' closes nothing"},
        YamlCase{"MissingComma", "a: {b: 1 c: 2}\n", "E0204 1:11+1 expected ',' or '}' before ':'"},
        YamlCase{"TextBehindAQuote", "a: ['b' c]\n", "E0204 1:9+1 expected ',' or ']' before 'c'"}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Quotes,
    Refused,
    testing::Values(
        YamlCase{"OpenDouble",
                 "a: 1\nb: \"x\nc: 2\n",
                 "E0204 2:4+2 the quoted text that begins here is not closed"},
        YamlCase{
            "OpenSingle", "a: 'x", "E0204 1:4+2 the quoted text that begins here is not closed"},
        YamlCase{
            "OpenAtTheEnd", "a: '\n", "E0204 1:4+1 the quoted text that begins here is not closed"},
        YamlCase{"DoubledAtTheEnd",
                 "a: 'x''\n",
                 "E0204 1:4+4 the quoted text that begins here is not closed"},
        YamlCase{"EscapedAtTheEnd",
                 "a: \"x\\\"\n",
                 "E0204 1:4+4 the quoted text that begins here is not closed"},
        YamlCase{"OpenInBrackets",
                 "a: [b, 'c]\n",
                 "E0204 1:8+3 the quoted text that begins here is not closed"},
        YamlCase{"OpenUpToADocumentMark",
                 "a: 'x\n...\nb'\n",
                 "E0204 1:4+2 the quoted text that begins here is not closed"},
        YamlCase{"ClosedByALaterOne",
                 "a: 'x\nb: 'y'\n",
                 "E0204 2:5+1 'y'' follows a closing quote (note 1:4+2 the quoted text that begins "
                 "here goes over lines)"},
        YamlCase{"Apostrophe", "a: 'it's'\n", "E0204 1:8+1 's'' follows a closing quote"},
        YamlCase{"UnknownEscape", "a: \"x\\q\"\n", "E0204 1:8+1 unknown escape before '\"'"},
        YamlCase{"ControlByEscape",
                 "a: \"x\\0\"\n",
                 "E0203 1:6+2 escape '\\0' is not allowed in a text"},
        YamlCase{"ControlByNumber",
                 "a: \"\\t\\x41 \\u001b[\"\n",
                 "E0203 1:12+6 escape '\\u001b' is not allowed in a text"},
        YamlCase{"ControlBehindABackslash",
                 "a: \"\\\\0 \\e\"\n",
                 "E0203 1:9+2 escape '\\e' is not allowed in a text"},
        YamlCase{"OrderMarkByNumber",
                 "a: \"\\U0000feff\"\n",
                 "E0203 1:5+10 escape '\\U0000feff' is not allowed in a text"},
        YamlCase{"EscapeThatTheParserGarbles",
                 "a: \"\\N\"\n",
                 "E0203 1:5+2 escape '\\N' is not allowed in a text"}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Indentation,
    Refused,
    testing::Values(
        YamlCase{"Tab", "a:\n\tb: 1\n", "E0203 2:1+1 tab in the indentation"},
        YamlCase{"TabBehindSpaces", "a:\n  \tb: 1\n", "E0203 2:3+1 tab in the indentation"},
        YamlCase{"TabInAContinuedText", "a: x\n\ty\n", "E0203 2:1+1 tab in the indentation"},
        YamlCase{"TabInABlockScalar", "a: |\n\tx\n", "E0203 2:1+1 tab in the indentation"},
        YamlCase{"TooDeep", "a: 1\n  b: 2\n", "E0204 2:4+1 ':' is not allowed here"},
        YamlCase{"BetweenTwo",
                 "a:\n    b: 1\n  c: 2\n",
                 "E0204 3:3+1 'c' does not fit into the mapping above it"},
        YamlCase{"ItemBetweenTwo",
                 "a:\n  - x\n - y\n",
                 "E0204 3:2+1 '-' does not fit into the mapping above it"},
        YamlCase{"ItemInAMapping",
                 "a: 1\n- b\n",
                 "E0204 2:1+1 '-' does not fit into the mapping above it"},
        YamlCase{"ItemOnTheLineOfItsKey", "a: - b\n", "E0204 1:4+1 '-' cannot begin an item here"},
        YamlCase{"NoColon", "a: 1\nb 2\nc: 3\n", "E0204 2:1+3 this line has no ':' behind its key"},
        YamlCase{"NoColonTwice",
                 "a: 1\n# b\nb 2\n\nc\nd: 3\n",
                 "E0204 3:1+3 this line has no ':' behind its key"},
        YamlCase{"NoSpaceBehindTheColon",
                 "a:\n  b: 1\n  c:2\n  d: 3\n",
                 "E0204 3:3+3 this line has no ':' behind its key"},
        YamlCase{"NoColonOnTheFirstLine",
                 "a\nb: 1\n",
                 "E0204 1:1+1 this line has no ':' behind its key"},
        YamlCase{"TwoColons", "a: b: c\n", "E0204 1:5+1 ':' is not allowed here"}),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Signs,
    Refused,
    testing::Values(
        YamlCase{"At", "a: @x\n", "E0204 1:4+1 '@x' cannot begin a value"},
        YamlCase{"Percent", "a: é\nb: %\n", "E0204 2:4+1 '%' cannot begin a value"},
        YamlCase{"Ampersand", "a: & b\n", "E0204 1:5+1 '&' needs a name behind it"},
        YamlCase{"Asterisk", "a: * b\n", "E0204 1:5+1 '*' needs a name behind it"},
        YamlCase{"Version", "%YAML 3.0\n---\na: 1\n", "E0204 1:1+1 YAML major version too large"},
        YamlCase{"BlockHeader", "a: |x\n  y\n", "E0204 1:5+1 'x' is not allowed after '|' or '>'"},
        YamlCase{"InvalidBytes", "a: \xFF\n", "E0202 1:4+1 byte 0xFF at offset 3 is not UTF-8"}),
    name_of_case);

TEST(Yaml, ReportsSeveralMistakesAtOnce) {
  EXPECT_EQ(complaints("a: !x 1\na: 2\n<<: 3\n"),
            "E0208 1:4+2 tag '!x' is not supported\n"
            "E0207 2:1+1 key 'a' is given twice (note 1:1+1 first given here)\n"
            "E0208 3:1+2 merge key '<<' is not supported\n");
}

// Beyond 16 keys there is a table of them.
TEST(Yaml, FindsARepeatedKeyInALongMapping) {
  std::string text;
  for (int i = 10; i < 40; ++i) {
    text += "k" + std::to_string(i) + ": {a: 1}\n";
  }

  EXPECT_EQ(complaints(text + "k11: 1\nk39: 2\na: 3\n"),
            "E0207 31:1+3 key 'k11' is given twice (note 2:1+3 first given here)\n"
            "E0207 32:1+3 key 'k39' is given twice (note 30:1+3 first given here)\n");
}

TEST(Yaml, GivesUpAfterAHundredMistakes) {
  std::string text;
  for (int i = 0; i < 1000; ++i) {
    text += "a: 1\n";
  }
  Diagnostics found;

  read_yaml({.path = "test.yaml", .text = text}, {}, found);

  EXPECT_EQ(found.error_count(), 100);
}

TEST(Yaml, HintsAtTheSpaceBehindAColon) {
  Diagnostics found;

  read_yaml({.path = "test.yaml", .text = "kinestat:1\nname:x\n"}, {}, found);

  ASSERT_EQ(found.error_count(), 1);
  EXPECT_EQ(found.items()[0].code, "E0304");
  EXPECT_EQ(found.items()[0].hint, "write a space after the ':' of each key");
}

TEST(Yaml, FindsKeysOfAMappingOnly) {
  const YamlNode root = read("a: 1\nb: [a]\n");

  ASSERT_NE(root.find("a"), nullptr);
  EXPECT_EQ(root.find("a")->text, "1");
  EXPECT_EQ(root.find("c"), nullptr);
  EXPECT_EQ(root.find("b")->find("a"), nullptr);
}

}  // namespace
}  // namespace kinestat
