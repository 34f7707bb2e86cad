#include "io/yaml_tree.hpp"

#include <string>
#include <string_view>
#include <sys/resource.h>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace kinestat {
namespace {

std::string place(SourceRange where) {
  return fmt::format("{}:{}+{}", where.line, where.column, where.length);
}

// "E0204 2:3+1 message (note 1:1+1 message)", one line a diagnostic.
std::string complaints(const std::string& text, const ReadLimits& limits = {}) {
  Diagnostics found;
  const auto root = read_yaml({.path = "test.yaml", .text = text}, limits, found);
  EXPECT_EQ(root.has_value(), !found.has_errors());
  std::string result;
  for (const Diagnostic& item : found.items()) {
    result += fmt::format("{} {} {}", item.code, place(item.where), item.message);
    for (const Note& note : item.notes) {
      result += fmt::format(" (note {} {})", place(note.where), note.message);
    }
    result += "\n";
  }
  return result;
}

YamlNode read(const std::string& text) {
  Diagnostics found;
  auto root = read_yaml({.path = "test.yaml", .text = text}, {}, found);
  EXPECT_FALSE(found.has_errors()) << (found.has_errors() ? found.items()[0].message : "");
  return root.value_or(YamlNode{});
}

// The value of key 'a', which the text must have.
YamlNode value_of(const std::string& text) {
  const YamlNode root = read(text);
  const YamlNode* const value = root.find("a");
  EXPECT_NE(value, nullptr);
  return value == nullptr ? YamlNode{} : *value;
}

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

struct Case {
  std::string name;
  std::string text;
  std::string expected;
};

std::string name_of(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

class YamlShape : public testing::TestWithParam<Case> {};

TEST_P(YamlShape, IsThatOfTheText) {
  EXPECT_EQ(shape(read(GetParam().text)), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Collections,
    YamlShape,
    testing::Values(
        Case{"OrderOfTheFile", "b: 1\na: 2\n", "{b: 1, a: 2}"},
        Case{
            "BlockInBlock", "a:\n  b:\n  - 1\n  - c: 2\n    d: 3\n", "{a: {b: [1, {c: 2, d: 3}]}}"},
        Case{"Brackets", "a: {b: [1, [2], {}], c: []}\n", "{a: {b: [1, [2], {}], c: []}}"},
        Case{"BracketsOverLines", "a: [1,\n 2,\n]\nb: 3\n", "{a: [1, 2], b: 3}"},
        Case{"PairInAList", "a: [b: 1]\n", "{a: [{b: 1}]}"},
        Case{"KeyWithoutValueInBraces", "a: {b, c: 1}\n", "{a: {b: ~, c: 1}}"},
        Case{"ExplicitKey", "? a\n: 1\n? b\n", "{a: 1, b: ~}"},
        Case{"Json", "{\"a\":[1,\"b\"],\"c\":{\"d\":null}}", "{a: [1, 'b'], c: {d: ~}}"},
        Case{"JsonIndentedByTabs", "{\n\t\"a\": 1\n}\n", "{a: 1}"},
        Case{"DocumentMarks", "%YAML 1.2\n---\na: 1\n...\n", "{a: 1}"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Scalars,
    YamlShape,
    testing::Values(
        Case{"Nulls", "a:\nb: ~\nc: null\nd: [~, null]\n", "{a: ~, b: ~, c: ~, d: [~, ~]}"},
        Case{"EmptyItem", "a:\n-\n- 1\n", "{a: [~, 1]}"},
        Case{"Quoted", "a: 'it''s'\nb: \"x\\ty\"\n'c d': ''\n", "{a: 'it's', b: 'x\ty', c d: ''}"},
        Case{"NumbersStayText", "a: 010\nb: 1e400\nc: no\n", "{a: 010, b: 1e400, c: no}"},
        Case{"QuotedNull", "a: '~'\nb: \"\"\n", "{a: '~', b: ''}"},
        Case{"Folded", "a: one\n  two\nb: \"one\n  two\"\n", "{a: one two, b: 'one two'}"},
        Case{"Block", "a: |\n  x: [\n  'y\nb: >-\n  p\n  q\n", "{a: 'x: [\n'y\n', b: 'p q'}"},
        Case{"QuotedMergeKey", "'<<': 1\n", "{<<: 1}"},
        Case{"MarksInsidePlainText",
             "a: it's [x] {y} 'z # no\nb: x#y\nc: -1\nd: a,b\n",
             "{a: it's [x] {y} 'z, b: x#y, c: -1, d: a,b}"},
        Case{"ContinuedPlainTextWithMarks", "a: x\n  'y [\n  } z\n", "{a: x 'y [ } z}"},
        Case{"Comments", "# [ { '\na: 1 # ] } \"\n# end", "{a: 1}"},
        Case{"CommentBehindBracket", "a: [1] # it's\n", "{a: [1]}"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Aliases,
    YamlShape,
    testing::Values(Case{"OfAScalar", "a: &x 1\nb: *x\n", "{a: 1, b: 1}"},
                    Case{"OfAMapping",
                         "a: &x {b: [1]}\nc: [*x, *x]\n",
                         "{a: {b: [1]}, c: [{b: [1]}, {b: [1]}]}"},
                    Case{"OfABlock", "a: &x\n  b: 1\nc: *x\n", "{a: {b: 1}, c: {b: 1}}"},
                    Case{"OfANull", "a: &x\nb: *x\n", "{a: ~, b: ~}"},
                    Case{"OfAnAlias", "a: &x 1\nb: &y [*x]\nc: *y\n", "{a: 1, b: [1], c: [1]}"},
                    Case{"AnchorUsedAnew", "a: &x 1\nb: &x 2\nc: *x\n", "{a: 1, b: 2, c: 2}"},
                    Case{"AsAKey", "a: &x b\n*x : 1\n", "{a: b, b: 1}"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Encodings,
    YamlShape,
    testing::Values(Case{"OrderMark",
                         "\xEF\xBB\xBF"
                         "a: 1\n",
                         "{a: 1}"},
                    Case{"CarriageReturns",
                         "a: |\r\n  x\r\n  y\r\nb: [1,\r\n 2]\r\nc: p\r\n  q\r\n",
                         "{a: 'x\ny\n', b: [1, 2], c: p q}"},
                    Case{"NoLineEndAtTheEnd", "a: 1", "{a: 1}"},
                    Case{"OtherScripts", "привет: día\n", "{привет: día}"}),
    name_of);

class Refused : public testing::TestWithParam<Case> {};

TEST_P(Refused, NamesCodePlaceAndCause) {
  EXPECT_EQ(complaints(GetParam().text), GetParam().expected + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    Documents,
    Refused,
    testing::Values(
        Case{"Empty", "", "E0205 0:0+0 empty document"},
        Case{"OnlyOrderMark", "\xEF\xBB\xBF", "E0205 0:0+0 empty document"},
        Case{"OnlyComments", "# one\n\n  # two\n", "E0205 0:0+0 empty document"},
        Case{"OnlyADocumentMark", "---\n", "E0205 0:0+0 empty document"},
        Case{"Null", "~\n", "E0205 0:0+0 empty document"},
        Case{"RootIsAList", "- a\n- b\n", "E0304 1:1+1 expected a mapping, found a list"},
        Case{"RootIsAScalar",
             "\nfour bar\n",
             "E0304 2:1+8 expected a mapping, found a single value"},
        Case{"TwoDocuments", "a: 1\n---\nb: 2\n", "E0206 2:1+3 a second document begins here"},
        Case{"SecondBehindAnEnd", "a: 1\n...\n--- b", "E0206 3:1+3 a second document begins here"},
        Case{"EmptySecond", "a: 1\n---\n", "E0206 2:1+3 a second document begins here"},
        Case{"EmptyFirst", "---\n---\na: 1\n", "E0206 2:1+3 a second document begins here"},
        Case{"BehindTheRoot",
             "{a: 1} b\n",
             "E0204 1:8+1 this stands behind the end of the document "
             "(note 1:1+1 the document begins here)"},
        Case{"ListThenMapping",
             "- a\nb: 1\n",
             "E0204 2:1+1 this stands behind the end of the document "
             "(note 1:1+1 the document begins here)"},
        Case{"FirstLineIndented",
             " a: 1\nb: 2\n",
             "E0204 2:1+1 this stands behind the end of the document "
             "(note 1:2+1 the document begins here)"},
        Case{"BehindItsEnd",
             "a: 1\n...\nb: 2...\n",
             "E0204 3:1+1 this stands behind the end of the document "
             "(note 2:1+3 the document ends here)"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Keys,
    Refused,
    testing::Values(
        Case{"TwiceAtTheTop",
             "name: 1\nb: 2\nname: 3\n",
             "E0207 3:1+4 key 'name' is given twice (note 1:1+4 first given here)"},
        Case{"TwiceNested",
             "a:\n  b: 1\n  \"b\": 2\n",
             "E0207 3:3+3 key 'b' is given twice (note 2:3+1 first given here)"},
        Case{"TwiceInBraces",
             "a: {é: 1, é: 2}\n",
             "E0207 1:11+1 key 'é' is given twice (note 1:5+1 first given here)"},
        Case{"ThreeTimes",
             "a: 1\na: 2\na: 3\n",
             "E0207 2:1+1 key 'a' is given twice (note 1:1+1 first given here)\n"
             "E0207 3:1+1 key 'a' is given twice (note 1:1+1 first given here)"},
        Case{
            "Merge", "a: &x {b: 1}\nc:\n  <<: *x\n", "E0208 3:3+2 merge key '<<' is not supported"},
        Case{"List", "[a, b]: 1\n", "E0208 1:1+1 a list or mapping cannot be a key"},
        Case{"Mapping", "a: {{b: 1} : 2}\n", "E0208 1:5+1 a list or mapping cannot be a key"},
        Case{"ExplicitList", "? - a\n: 1\n", "E0208 1:3+1 a list or mapping cannot be a key"},
        Case{"Missing", ": 1\n", "E0208 1:1+1 a key is missing or null"},
        Case{"Null", "a: {~: 1}\n", "E0208 1:5+1 a key is missing or null"},
        Case{"WithoutColon", "a: 1\nkey\n", "E0204 2:1+3 'key' has no ':' behind it"},
        Case{
            "WithoutColonAtTheEnd", "a:\n  b: 1\n  key", "E0204 3:3+3 'key' has no ':' behind it"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Features,
    Refused,
    testing::Values(
        Case{"PythonTag",
             "a: !!python/object:os.system x\n",
             "E0208 1:4+25 tag '!!python/object:os.system' is not supported"},
        Case{"LocalTag", "a: [!x 1]\n", "E0208 1:5+2 tag '!x' is not supported"},
        Case{"TagOfAMapping", "a: !!map\n  b: 1\n", "E0208 1:4+5 tag '!!map' is not supported"},
        Case{"TagBehindAnAnchor", "a: &x !!str 1\n", "E0208 1:7+5 tag '!!str' is not supported"},
        Case{"TagWithoutValue", "a: !!str\n", "E0208 1:4+5 tag '!!str' is not supported"},
        Case{"TagWithoutName", "a: ! 1\n", "E0208 1:4+1 tag '!' is not supported"},
        Case{"TagOfAKey", "!x a: 1\n", "E0208 1:1+2 tag '!x' is not supported"},
        Case{"UnknownAlias", "a: [*b, 1]\n", "E0209 1:5+2 alias '*b' names no anchor before it"},
        Case{"AliasBeforeItsAnchor",
             "a: *x\nb: &x 1\n",
             "E0209 1:4+2 alias '*x' names no anchor before it"},
        Case{"AliasInsideItself",
             "a: &x [1, *x]\n",
             "E0209 1:11+2 alias '*x' stands inside what it names "
             "(note 1:7+1 the anchored value begins here)"},
        Case{"AliasOfTheRoot",
             "&x\na: *x\n",
             "E0209 2:4+2 alias '*x' stands inside what it names "
             "(note 2:1+1 the anchored value begins here)"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Brackets,
    Refused,
    testing::Values(
        Case{"OpenList", "a: [1, 2\nb: 3\n", "E0204 1:4+1 '[' is not closed"},
        Case{"OpenMapping", "a:\n  b: {c: 1\n", "E0204 2:6+1 '{' is not closed"},
        Case{"InnermostOpen", "a: [1, {b: [2], c: 3\n", "E0204 1:8+1 '{' is not closed"},
        Case{"Crossed",
             "a: [1, {b: 2]}\n",
             "E0204 1:8+1 '{' is not closed (note 1:13+1 ']' stands here)"},
        Case{"OtherBracket",
             "a: [7, 0}\n",
             "E0204 1:9+1 '}' cannot close '[' (note 1:4+1 '[' is open since here)"},
        Case{"OneTooManyInside",
             "a: {b: [7, 0]]}\n",
             "E0204 1:14+1 ']' cannot close '{' (note 1:4+1 '{' is open since here)"},
        Case{"ClosesNothing", "a: 1\nb: ]\n", "E0204 2:4+1 ']' closes nothing"},
        Case{"OneTooMany", "a: {b: 1}}\n", "E0204 1:10+1 '}' closes nothing"},
        Case{"MissingComma", "a: {b: 1 c: 2}\n", "E0204 1:11+1 expected ',' or '}' before ':'"},
        Case{"TextBehindAQuote", "a: ['b' c]\n", "E0204 1:9+1 expected ',' or ']' before 'c'"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Quotes,
    Refused,
    testing::Values(
        Case{"OpenDouble",
             "a: 1\nb: \"x\nc: 2\n",
             "E0204 2:4+2 the quoted text that begins here is not closed"},
        Case{"OpenSingle", "a: 'x", "E0204 1:4+2 the quoted text that begins here is not closed"},
        Case{
            "OpenAtTheEnd", "a: '\n", "E0204 1:4+1 the quoted text that begins here is not closed"},
        Case{"DoubledAtTheEnd",
             "a: 'x''\n",
             "E0204 1:4+4 the quoted text that begins here is not closed"},
        Case{"EscapedAtTheEnd",
             "a: \"x\\\"\n",
             "E0204 1:4+4 the quoted text that begins here is not closed"},
        Case{"OpenInBrackets",
             "a: [b, 'c]\n",
             "E0204 1:8+3 the quoted text that begins here is not closed"},
        Case{"OpenUpToADocumentMark",
             "a: 'x\n...\nb'\n",
             "E0204 1:4+2 the quoted text that begins here is not closed"},
        Case{"ClosedByALaterOne",
             "a: 'x\nb: 'y'\n",
             "E0204 2:5+1 'y'' stands behind a closing quote "
             "(note 1:4+2 the quoted text that begins here goes over lines)"},
        Case{"Apostrophe", "a: 'it's'\n", "E0204 1:8+1 's'' stands behind a closing quote"},
        Case{"UnknownEscape", "a: \"x\\q\"\n", "E0204 1:8+1 unknown escape before '\"'"},
        Case{"ControlByEscape", "a: \"x\\0\"\n", "E0203 1:6+2 escape '\\0' cannot stand in a text"},
        Case{"ControlByNumber",
             "a: \"\\t\\x41 \\u001b[\"\n",
             "E0203 1:12+6 escape '\\u001b' cannot stand in a text"},
        Case{"ControlBehindABackslash",
             "a: \"\\\\0 \\e\"\n",
             "E0203 1:9+2 escape '\\e' cannot stand in a text"},
        Case{"OrderMarkByNumber",
             "a: \"\\U0000feff\"\n",
             "E0203 1:5+10 escape '\\U0000feff' cannot stand in a text"},
        Case{"EscapeThatTheParserGarbles",
             "a: \"\\N\"\n",
             "E0203 1:5+2 escape '\\N' cannot stand in a text"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Indentation,
    Refused,
    testing::Values(
        Case{"Tab", "a:\n\tb: 1\n", "E0203 2:1+1 tab in the indentation"},
        Case{"TabBehindSpaces", "a:\n  \tb: 1\n", "E0203 2:3+1 tab in the indentation"},
        Case{"TabInAContinuedText", "a: x\n\ty\n", "E0203 2:1+1 tab in the indentation"},
        Case{"TabInABlockScalar", "a: |\n\tx\n", "E0203 2:1+1 tab in the indentation"},
        Case{"TooDeep", "a: 1\n  b: 2\n", "E0204 2:4+1 ':' cannot stand here"},
        Case{"BetweenTwo",
             "a:\n    b: 1\n  c: 2\n",
             "E0204 3:3+1 'c' does not fit into the mapping above it"},
        Case{"ItemBetweenTwo",
             "a:\n  - x\n - y\n",
             "E0204 3:2+1 '-' does not fit into the mapping above it"},
        Case{"ItemInAMapping",
             "a: 1\n- b\n",
             "E0204 2:1+1 '-' does not fit into the mapping above it"},
        Case{"ItemOnTheLineOfItsKey", "a: - b\n", "E0204 1:4+1 '-' cannot begin an item here"},
        Case{"NoColon", "a: 1\nb 2\nc: 3\n", "E0204 2:1+3 this line has no ':' behind its key"},
        Case{"NoColonTwice",
             "a: 1\n# b\nb 2\n\nc\nd: 3\n",
             "E0204 3:1+3 this line has no ':' behind its key"},
        Case{"NoSpaceBehindTheColon",
             "a:\n  b: 1\n  c:2\n  d: 3\n",
             "E0204 3:3+3 this line has no ':' behind its key"},
        Case{"NoColonOnTheFirstLine",
             "a\nb: 1\n",
             "E0204 1:1+1 this line has no ':' behind its key"},
        Case{"TwoColons", "a: b: c\n", "E0204 1:5+1 ':' cannot stand here"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Signs,
    Refused,
    testing::Values(
        Case{"At", "a: @x\n", "E0204 1:4+1 '@x' cannot begin a value"},
        Case{"Percent", "a: é\nb: %\n", "E0204 2:4+1 '%' cannot begin a value"},
        Case{"Ampersand", "a: & b\n", "E0204 1:5+1 '&' needs a name behind it"},
        Case{"Asterisk", "a: * b\n", "E0204 1:5+1 '*' needs a name behind it"},
        Case{"Version", "%YAML 3.0\n---\na: 1\n", "E0204 1:1+1 YAML major version too large"},
        Case{"BlockHeader", "a: |x\n  y\n", "E0204 1:5+1 'x' cannot stand behind '|' or '>'"},
        Case{"InvalidBytes", "a: \xFF\n", "E0202 1:4+1 byte 0xFF at offset 3 is not UTF-8"}),
    name_of);

TEST(Yaml, ReportsSeveralMistakesAtOnce) {
  EXPECT_EQ(complaints("a: !x 1\na: 2\n<<: 3\n"),
            "E0208 1:4+2 tag '!x' is not supported\n"
            "E0207 2:1+1 key 'a' is given twice (note 1:1+1 first given here)\n"
            "E0208 3:1+2 merge key '<<' is not supported\n");
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

// The place of the value of 'a' and the column of its text: "line:column+length column".
class Place : public testing::TestWithParam<Case> {};

TEST_P(Place, IsThatInTheSource) {
  const YamlNode value = value_of(GetParam().text);

  EXPECT_EQ(fmt::format("{} {}", place(value.where), value.text_column), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Of,
    Place,
    testing::Values(Case{"PlainText", "a: N1 + N5\n", "1:4+7 4"},
                    Case{"TextBeforeAComment", "a: 2 mm   # length\n", "1:4+4 4"},
                    Case{"TextInBraces", "{b: 1, a: x y }\n", "1:11+3 11"},
                    Case{"SingleQuotes", "a: 'x y'\n", "1:4+5 5"},
                    Case{"DoubleQuotes", "a: \"x y\" # z\n", "1:4+5 5"},
                    Case{"EmptyQuotes", "a: ''\n", "1:4+2 5"},
                    Case{"DoubledQuote", "a: 'it''s'\n", "1:4+7 0"},
                    Case{"Escape", "a: \"x\\ty\"\n", "1:4+6 0"},
                    Case{"TextBeforeACommentOfOneSpace", "a: one # no\n", "1:4+3 4"},
                    Case{"FoldedText", "a: one  \n  two\n", "1:4+3 0"},
                    Case{"FoldedOnEqualText", "a: x\n\n  x\n", "1:4+1 0"},
                    Case{"FoldedQuotes", "a: 'one\n  two'\n", "1:4+4 0"},
                    Case{"BlockScalar", "a: |-\n  x\n", "1:4+2 0"},
                    Case{"BehindAnAnchor", "a: &x  one\n", "1:8+3 8"},
                    Case{"BehindAnAnchorAndALine", "a: &x # c\n  one\n", "2:3+3 3"},
                    Case{"Alias", "b: &x one\na: *x\n", "1:7+3 7"},
                    Case{"AliasOfABlock", "b: &x\n  c: 1\na: *x\n", "2:3+1 0"},
                    Case{"BlockMapping", "a:\n  b: 1\n", "2:3+1 0"},
                    Case{"BlockList", "a:\n- b\n", "2:1+1 0"},
                    Case{"Braces", "a: {b: 1}\n", "1:4+1 0"},
                    Case{"NullIsItsKey", "b: 1\na:\nc: 2\n", "2:1+1 0"},
                    Case{"WrittenNullIsItsKey", "a: ~\n", "1:1+1 0"},
                    Case{"NullInBracesIsItsKey", "{b: 1, a}\n", "1:8+1 0"},
                    Case{"QuotedKey", "'a' : x\n", "1:7+1 7"},
                    Case{"BehindOtherScripts", "{día: ñandú, a: señor}\n", "1:17+5 17"},
                    Case{"BehindFourByteCharacters", "{😀: 1, a: 2}\n", "1:11+1 11"},
                    Case{"BehindAnOrderMark",
                         "\xEF\xBB\xBF"
                         "a: é x\n",
                         "1:4+3 4"},
                    Case{"BehindCarriageReturns", "b: é\r\n\r\na: x y\r\n", "3:4+3 4"},
                    Case{"QuotesBeforeACarriageReturn", "a: 'x\r\n  y'\r\n", "1:4+2 0"}),
    name_of);

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

TEST(Limits, AdmitTheDepthTheyName) {
  const std::string text = "a: " + std::string(63, '[') + std::string(63, ']');

  EXPECT_EQ(complaints(text), "");
}

TEST(Limits, RefuseBracketsThatAreTooDeep) {
  const std::string text = "a: " + std::string(64, '[') + std::string(64, ']');

  EXPECT_EQ(complaints(text), "E0210 1:67+1 more than 64 levels of nesting\n");
}

TEST(Limits, RefuseBlocksThatAreTooDeep) {
  std::string text;
  for (std::size_t i = 0; i < 65; ++i) {
    text += std::string(i, ' ') + "a:\n";
  }

  EXPECT_EQ(complaints(text), "E0210 65:65+1 more than 64 levels of nesting\n");
}

TEST(Limits, RefuseListsOfListsThatAreTooDeep) {
  std::string text = "a:\n";
  for (int i = 0; i < 100000; ++i) {
    text += "- ";
  }

  EXPECT_EQ(complaints(text), "E0210 2:127+1 more than 64 levels of nesting\n");
}

TEST(Limits, CountTheDepthOfAliases) {
  const std::string text = "a: &x " + std::string(40, '[') + std::string(40, ']') +
                           "\nb: " + std::string(30, '[') + "*x" + std::string(30, ']') + "\n";

  EXPECT_EQ(complaints(text), "E0210 2:34+2 more than 64 levels of nesting\n");
}

TEST(Limits, OfDepthCanBeRaisedToFourHundred) {
  const auto nested = [](std::size_t depth) {
    return "a: " + std::string(depth - 1, '[') + std::string(depth - 1, ']');
  };

  EXPECT_EQ(complaints(nested(400), {.depth = 100000}), "");
  EXPECT_EQ(complaints(nested(401), {.depth = 100000}),
            "E0210 1:403+1 more than 400 levels of nesting\n");
}

TEST(Limits, RefuseTooManyValues) {
  EXPECT_EQ(complaints("a: [1, 2]\n", {.nodes = 4}), "");
  EXPECT_EQ(complaints("a: [1, 2, 3]\n", {.nodes = 4}),
            "E0210 1:11+1 more than 4 values in the file, aliases expanded\n");
}

TEST(Limits, RefuseTwoHundredThousandAndOneValues) {
  std::string text = "a:\n";  // the root and the list are two values more
  for (int i = 0; i < 199999; ++i) {
    text += "- 1\n";
  }

  EXPECT_EQ(complaints(text),
            "E0210 200000:3+1 more than 200000 values in the file, aliases expanded\n");
}

TEST(Limits, RefuseALongValue) {
  EXPECT_EQ(complaints("a: 12345678\n", {.scalar = 8}), "");
  EXPECT_EQ(complaints("a: 123456789\n", {.scalar = 8}),
            "E0210 1:4+9 value is 9 bytes long, the limit is 8\n");
}

TEST(Limits, RefuseALongKey) {
  EXPECT_EQ(complaints("123456789: a\n", {.scalar = 8}),
            "E0210 1:1+9 value is 9 bytes long, the limit is 8\n");
}

TEST(Limits, RefuseAValueOfTenMegabytes) {
  const std::string text = "a: '" + std::string(10000000, 'x') + "'\n";

  EXPECT_EQ(complaints(text),
            "E0210 1:4+10000002 value is 10000000 bytes long, the limit is 65536\n");
}

TEST(Limits, RefuseAliasesThatRepeatMuchText) {
  std::string text = "a: &x " + std::string(1000, 'x') + "\nb:\n";
  for (int i = 0; i < 20; ++i) {
    text += "- *x\n";
  }

  EXPECT_EQ(complaints(text, {.bytes = 20000}), "");
  EXPECT_EQ(complaints(text, {.bytes = 19999}),
            "E0210 22:3+2 aliases repeat more than 19999 bytes of text\n");
}

struct Cost {
  double seconds = 0.0;  // of the processor, for a busy machine must not look like a slow reader
  long kilobytes = 0;
};

double processor_seconds(const rusage& usage) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Time and the growth of the largest memory the process has had, while a text is refused.
Cost cost_of_refusal(const std::string& text, std::string_view code) {
  rusage before = {};
  ::getrusage(RUSAGE_SELF, &before);
  Diagnostics found;
  const auto root = read_yaml({.path = "test.yaml", .text = text}, {}, found);
  rusage after = {};
  ::getrusage(RUSAGE_SELF, &after);
  EXPECT_FALSE(root.has_value());
  EXPECT_EQ(found.items().empty() ? "" : found.items()[0].code, code);
  return {.seconds = processor_seconds(after) - processor_seconds(before),
          .kilobytes = after.ru_maxrss - before.ru_maxrss};
}

TEST(Limits, StopABombOfAliasesBeforeItGoesOff) {
  std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 40; ++i) {
    text += fmt::format("a{0}: &a{0} [*a{1}, *a{1}, *a{1}, *a{1}, *a{1}, *a{1}]\n", i, i - 1);
  }

  const Cost cost = cost_of_refusal(text, "E0210");

  EXPECT_LT(cost.seconds, 0.010);
  EXPECT_LT(cost.kilobytes, 20000);
}

class Bomb : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(Bomb, IsRefusedInASecondAndInBoundedMemory) {
  const auto& [sign, code] = GetParam();
  std::string text;
  while (text.size() < 1000000) {
    text += sign;
  }

  const Cost cost = cost_of_refusal(text, code);

  EXPECT_LT(cost.seconds, 1.0);
  EXPECT_LT(cost.kilobytes, 64000);
}

INSTANTIATE_TEST_SUITE_P(MillionBytes,
                         Bomb,
                         testing::Values(std::pair("[", "E0210"),
                                         std::pair("{", "E0210"),
                                         std::pair("a: [", "E0210"),
                                         std::pair("- ", "E0210"),
                                         std::pair("? ", "E0210"),
                                         std::pair("[a,", "E0210"),
                                         std::pair("]", "E0204"),
                                         std::pair("'", "E0210"),
                                         std::pair("&a ", "E0204")),
                         [](const auto& row) { return "Sign" + std::to_string(row.index); });

}  // namespace
}  // namespace kinestat
