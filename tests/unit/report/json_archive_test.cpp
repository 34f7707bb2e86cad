#include "report/json_archive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "report/json_values.hpp"

namespace kinestat {

namespace {

// Everything that JSON has.
struct Sample {
  std::vector<std::string> names;
  std::vector<std::optional<double>> numbers;
};

const Record<Sample>& sample_record() {
  static const Record<Sample> record("A sample.", [](Record<Sample>& keys) {
    keys.count("count", "Names.", [](const Sample& v) { return static_cast<int>(v.names.size()); });
    keys.quantity("length", QuantityKind::length, "12 mm.", [](const Sample&) {
      return std::optional(0.012);
    });
    keys.names("names", "Texts.", [](const Sample& v, const EachName& each) {
      for (const std::string& name : v.names) {
        each(name);
      }
    });
    keys.custom("numbers",
                list_shape(number_shape(Bare::number, true)),
                "Numbers.",
                [](const Sample& v, Archive& to) {
                  to.begin_list();
                  for (const std::optional<double>& one : v.numbers) {
                    to.number(one, {});
                  }
                  to.end_list();
                });
    keys.custom(
        "by_name", map_shape(flag_shape(false)), "Flags.", [](const Sample& v, Archive& to) {
          to.begin_map();
          for (const std::string& name : v.names) {
            to.element(name, {});
            to.flag(name.size() > 1);
          }
          to.end_map();
        });
  });
  return record;
}

FileUnits millimetres() {
  FileUnits units;
  EXPECT_FALSE(units.set(QuantityKind::length, "mm").has_value());
  return units;
}

std::string text_of(const Sample& sample, JsonLayout layout) {
  const FileUnits units = millimetres();
  return json_text(sample_record(), sample, units, layout);
}

TEST(JsonArchive, WritesAKeyALine) {
  EXPECT_EQ(text_of({.names = {"a", "b c"}, .numbers = {1.0, std::nullopt}}, JsonLayout::indented),
            R"({
  "count": 2,
  "length": 12.0,
  "names": [
    "a",
    "b c"
  ],
  "numbers": [
    1.0,
    null
  ],
  "by_name": {
    "a": false,
    "b c": true
  }
}
)");
}

TEST(JsonArchive, WritesAllOnOneLine) {
  EXPECT_EQ(text_of({.names = {"a"}, .numbers = {-0.5}}, JsonLayout::line),
            R"({"count":1,"length":12.0,"names":["a"],"numbers":[-0.5],"by_name":{"a":false}})"
            "\n");
}

TEST(JsonArchive, HasNothingInWhatIsEmpty) {
  EXPECT_EQ(text_of({}, JsonLayout::indented),
            "{\n  \"count\": 0,\n  \"length\": 12.0,\n  \"names\": [],\n  \"numbers\": [],\n"
            "  \"by_name\": {}\n}\n");
}

TEST(JsonArchive, NumbersReadBackAsTheSameDoubles) {
  const Sample sample{.names = {},
                      .numbers = {0.1,
                                  -0.0,
                                  1e15,
                                  1234567890123456.5,
                                  9007199254740993.0,
                                  1e16,
                                  1e-5,
                                  5e-324,
                                  1.7976931348623157e308,
                                  1.0 / 3.0}};
  const Json json = Json::parse(text_of(sample, JsonLayout::line));
  ASSERT_EQ(json["numbers"].size(), sample.numbers.size());
  for (std::size_t i = 0; i < sample.numbers.size(); ++i) {
    EXPECT_TRUE(json["numbers"][i].is_number_float());
    EXPECT_EQ(json["numbers"][i].get<double>(), *sample.numbers[i]);
    EXPECT_FALSE(json["numbers"][i].get<double>() == 0.0 &&
                 std::signbit(json["numbers"][i].get<double>()));
  }
}

TEST(JsonArchive, HasNullWhereANumberIsNotFinite) {
  using Limits = std::numeric_limits<double>;
  const std::string text = text_of(
      {.names = {}, .numbers = {Limits::infinity(), Limits::quiet_NaN()}}, JsonLayout::line);
  EXPECT_NE(text.find("\"numbers\":[null,null]"), std::string::npos) << text;
}

TEST(JsonArchive, TextsReadBackInEveryLayout) {
  const Sample sample{.names = {"\"quoted\\\"", "tab\tand\nfeed", "Zahnräder ✓ 🚲", "\x01\x7f"},
                      .numbers = {}};
  for (const JsonLayout layout : {JsonLayout::indented, JsonLayout::line, JsonLayout::ascii_line}) {
    const std::string text = text_of(sample, layout);
    const Json json = Json::parse(text);
    EXPECT_EQ(json["names"].get<std::vector<std::string>>(), sample.names);
    for (const std::string& name : sample.names) {
      EXPECT_TRUE(json["by_name"].contains(name)) << text;
    }
    const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
    EXPECT_EQ(std::all_of(text.begin(), text.end(), is_ascii), layout == JsonLayout::ascii_line);
  }
}

}  // namespace
}  // namespace kinestat
