#include "io/byte_scan.hpp"

#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/utf8.hpp"

namespace kinestat {
namespace {

using namespace std::string_literals;

// "E0202 2:3 message", one line a diagnostic.
std::string byte_complaints(const std::string& text) {
  Diagnostics found;
  const bool is_clean = scan_bytes({.path = "test.yaml", .text = text}, found);
  EXPECT_EQ(is_clean, !found.has_errors());
  std::string result;
  for (const Diagnostic& item : found.items()) {
    EXPECT_FALSE(item.hint.empty());
    result +=
        fmt::format("{} {}:{} {}\n", item.code, item.where.line, item.where.column, item.message);
  }
  return result;
}

struct ByteCase {
  std::string name;
  std::string text;
  std::string expected;  // a line of complaints, or empty
};

std::string name_of_bytes(const testing::TestParamInfo<ByteCase>& info) {
  return info.param.name;
}

class BadBytes : public testing::TestWithParam<ByteCase> {};

TEST_P(BadBytes, AreNamedWithTheirPlace) {
  EXPECT_EQ(byte_complaints(GetParam().text), GetParam().expected + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    Encoding,
    BadBytes,
    testing::Values(
        ByteCase{"Latin1", "a: \xE9t\xE9\n", "E0202 1:4 byte 0xE9 at offset 3 is not UTF-8"},
        ByteCase{"LoneContinuation", "a\nb\x80", "E0202 2:2 byte 0x80 at offset 3 is not UTF-8"},
        ByteCase{
            "BehindOtherCharacters", "é: \xFF", "E0202 1:4 byte 0xFF at offset 4 is not UTF-8"},
        ByteCase{"Overlong2", "\xC0\xAF", "E0202 1:1 byte 0xC0 at offset 0 is not UTF-8"},
        ByteCase{"Overlong3", "\xE0\x80\xAF", "E0202 1:1 byte 0xE0 at offset 0 is not UTF-8"},
        ByteCase{"Overlong4", "\xF0\x80\x80\xAF", "E0202 1:1 byte 0xF0 at offset 0 is not UTF-8"},
        ByteCase{"HighSurrogate", "\xED\xA0\x80", "E0202 1:1 byte 0xED at offset 0 is not UTF-8"},
        ByteCase{"LowSurrogate", "\xED\xBF\xBF", "E0202 1:1 byte 0xED at offset 0 is not UTF-8"},
        ByteCase{
            "BeyondUnicode", "\xF4\x90\x80\x80", "E0202 1:1 byte 0xF4 at offset 0 is not UTF-8"},
        ByteCase{"TruncatedInside", "\xE2\x82 ", "E0202 1:1 byte 0xE2 at offset 0 is not UTF-8"},
        ByteCase{"TruncatedAtTheEnd",
                 "a: \xE2\x82",
                 "E0202 1:4 the file ends inside the character that begins at offset 3"},
        ByteCase{"OffsetCountsTheOrderMark",
                 "\xEF\xBB\xBF\xFF",
                 "E0202 1:1 byte 0xFF at offset 3 is not UTF-8"},
        ByteCase{"Utf16LittleEndian", "\xFF\xFE\x61\x00"s, "E0202 0:0 the file is UTF-16"},
        ByteCase{"Utf16BigEndian", "\xFE\xFF\x00\x61"s, "E0202 0:0 the file is UTF-16"},
        ByteCase{"Utf16WithoutMark", "a\0:\0"s, "E0202 0:0 the file is UTF-16"},
        ByteCase{"Utf32LittleEndian", "\xFF\xFE\0\0a\0\0\0"s, "E0202 0:0 the file is UTF-32"},
        ByteCase{"Utf32BigEndian", "\0\0\xFE\xFF\0\0\0a"s, "E0202 0:0 the file is UTF-32"},
        ByteCase{"Utf32WithoutMark", "a\0\0\0"s, "E0202 0:0 the file is UTF-32"},
        ByteCase{"Utf16BigEndianWithoutMark", "\0a\0:"s, "E0202 0:0 the file is UTF-16"}),
    name_of_bytes);

INSTANTIATE_TEST_SUITE_P(
    Controls,
    BadBytes,
    testing::Values(
        ByteCase{"Nul", "name: x\0y"s, "E0203 1:8 control character U+0000 at offset 7"},
        ByteCase{"Bell", "a\n\a", "E0203 2:1 control character U+0007 at offset 2"},
        ByteCase{"EndOfTransmission", "\x04", "E0203 1:1 control character U+0004 at offset 0"},
        ByteCase{"Escape", "\x1B[31m", "E0203 1:1 control character U+001B at offset 0"},
        ByteCase{"Delete", "a\x7F", "E0203 1:2 control character U+007F at offset 1"},
        ByteCase{"C1", "\xC2\x9B", "E0203 1:1 control character U+009B at offset 0"},
        ByteCase{"LoneCarriageReturn",
                 "a: 1\rb: 2\r",
                 "E0203 1:5 carriage return without line feed at offset 4"},
        ByteCase{"CarriageReturnAtTheEnd",
                 "a: 1\r",
                 "E0203 1:5 carriage return without line feed at offset 4"},
        ByteCase{"OrderMarkInside",
                 "a: 1\n\xEF\xBB\xBF",
                 "E0203 2:1 character U+FEFF at offset 5 is not allowed in YAML"},
        ByteCase{"Noncharacter",
                 "\xEF\xBF\xBF",
                 "E0203 1:1 character U+FFFF at offset 0 is not allowed in YAML"}),
    name_of_bytes);

class GoodBytes : public testing::TestWithParam<ByteCase> {};

TEST_P(GoodBytes, AreAccepted) {
  EXPECT_EQ(byte_complaints(GetParam().text), "");
}

INSTANTIATE_TEST_SUITE_P(
    Text,
    GoodBytes,
    testing::Values(ByteCase{"Empty", "", ""},
                    ByteCase{"TwoBytes", "a\n", ""},
                    ByteCase{"Utf8OrderMark", "\xEF\xBB\xBFkinestat: 1\n", ""},
                    ByteCase{"CarriageReturnLineFeed", "a: 1\r\nb: 2\r\n", ""},
                    ByteCase{"TabInsideALine", "a:\t1\n", ""},
                    ByteCase{"NextLine", "a: \xC2\x85\n", ""},
                    ByteCase{"SmallestOfEachSize", "\x20\xC2\xA0\xE0\xA0\x80\xF0\x90\x80\x80", ""},
                    ByteCase{"LargestOfEachSize", "\x7E\xDF\xBF\xEF\xBF\xBD\xF4\x8F\xBF\xBF", ""},
                    ByteCase{"AroundTheSurrogates", "\xED\x9F\xBF\xEE\x80\x80", ""}),
    name_of_bytes);

TEST(ByteScan, ReportsOnlyTheFirstFault) {
  EXPECT_EQ(byte_complaints("\xFF\xFF\a"), "E0202 1:1 byte 0xFF at offset 0 is not UTF-8\n");
}

TEST(ByteScan, SaysHowToSaveUtf16) {
  Diagnostics found;

  scan_bytes({.path = "test.yaml", .text = "\xFF\xFE"}, found);

  ASSERT_EQ(found.error_count(), 1);
  EXPECT_EQ(found.items()[0].hint, "save it as UTF-8");
}

TEST(Printable, LeavesTextAsItIs) {
  EXPECT_EQ(printable("héllo %s.yaml"), "héllo %s.yaml");
}

TEST(Printable, EscapesWhatATerminalWouldObeyOrNotShow) {
  EXPECT_EQ(printable("a\nb\x1B\t\xFF\xC3"), "a\\x0Ab\\x1B\\x09\\xFF\\xC3");
}

}  // namespace
}  // namespace kinestat
