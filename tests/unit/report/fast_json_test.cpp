#include "studies/compare/fast_json.hpp"

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "studies/compare/compare_json_text.hpp"

namespace kinestat {
namespace {

// Takes everything.
struct Listener {
  bool null() { return true; }

  bool boolean(bool) { return true; }

  bool number_integer(Json::number_integer_t) { return true; }

  bool number_unsigned(Json::number_unsigned_t) { return true; }

  bool number_float(double, const std::string&) { return true; }

  bool string(std::string&) { return true; }

  bool key(const std::string&) { return true; }

  bool start_object(std::size_t) { return true; }

  bool end_object() { return true; }

  bool start_array(std::size_t) { return true; }

  bool end_array() { return true; }
};

bool is_right(const std::string& text) {
  Listener listener;
  return read_fast_json(text, listener);
}

const std::string kReport =
    "{\"kinestat\": {\"report\": 1, \"a\": null}, \"list\": [0, -0, 12, -7, 0.5, -1.25e-3, 6E+2,\n"
    "  18446744073709551615, 1e300, true, false, [], {}, [[1]]],\r\n\t\"t\": \"\", \"ä😀\": \"é\",\n"
    "  \"e\": \"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e9\\ud83d\\ude00\"}\n";

TEST(FastJson, ReadsWhatAReportMayHold) {
  EXPECT_TRUE(is_right(kReport));
  EXPECT_TRUE(is_right("\xEF\xBB\xBF" + kReport));

  Diagnostics found;
  const std::optional<Json> read = read_json({.path = "r", .text = kReport}, found);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, Json::parse(kReport));
  EXPECT_EQ(read->dump(), Json::parse(kReport).dump());
}

// Whatever is changed in a report, both readers agree on whether it is JSON, and on what it says.
TEST(FastJson, AgreesWithTheOtherReader) {
  const std::string letters = "{}[]\",:\\eE+-.0189aunft \n\x01\x7F\x80\xC3\xFF";
  std::mt19937 random(20261128);
  int right = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = kReport;
    for (auto change = random() % 3; change < 3; ++change) {
      const std::size_t at = random() % text.size();
      const char letter = letters[random() % letters.size()];
      switch (random() % 3) {
        case 0:
          text[at] = letter;
          break;
        case 1:
          text.erase(at, 1);
          break;
        default:
          text.insert(at, 1, letter);
      }
    }
    if (is_right(text)) {
      ++right;
      ASSERT_TRUE(Json::accept(text)) << text;
      Diagnostics found;
      if (const std::optional<Json> read = read_json({.path = "r", .text = text}, found)) {
        ASSERT_EQ(read->dump(), Json::parse(text).dump()) << text;
      }
    }
  }
  EXPECT_GT(right, 1000);
}

}  // namespace
}  // namespace kinestat
