#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "description/cable_expansion.hpp"
#include "format/mechanism_reader.hpp"
#include "format/sections/sections.hpp"
#include "support/read_text.hpp"

namespace kinestat {
namespace {

std::string content_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// The declared sections as they are written.
std::string sections_text(const MechanismDescription& description) {
  std::string text;
  for (const auto& [key, value] : file_sections().text(without_cable_parts(description)).entries) {
    text += key + ":" + behind_key(value, 0);
  }
  return text;
}

// They alone, read again.
std::string read_and_written(const std::string& text) {
  const auto reading = read_text(text, [](const YamlNode& root, auto& found) {
    MechanismDescription description;
    file_sections().read_into(description, whole_file(root, found));
    return description;
  });
  EXPECT_EQ(reading.complaints(), Complaints{});
  return sections_text(reading.value);
}

TEST(RoundTrip, WritesTheSectionsOfEveryMechanismAsTheyReadBack) {
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(KINESTAT_MECHANISMS)) {
    if (entry.path().extension() != ".yaml") {
      continue;
    }
    SCOPED_TRACE(entry.path().filename());
    std::vector<std::string> sections;
    const auto reading =
        read_text(content_of(entry.path()), [&](const YamlNode& root, Diagnostics& found) {
          for (const YamlEntry& one : root.entries) {
            const bool is_usual = one.key == "space" && one.value.text == "spatial";
            sections.push_back(is_usual ? "" : one.key);
          }
          return read_mechanism(root, found);
        });
    ASSERT_TRUE(reading.value) << testing::PrintToString(reading.complaints());
    const std::string text = sections_text(*reading.value);

    EXPECT_EQ(read_and_written(text), text);
    for (const FormKey& key : file_sections().shape().keys) {
      const bool is_in_file = std::ranges::find(sections, key.key) != sections.end();
      EXPECT_EQ(("\n" + text).find("\n" + std::string(key.key) + ":") != std::string::npos,
                is_in_file)
          << key.key;
    }
    ++count;
  }
  EXPECT_GT(count, 50);
}

}  // namespace
}  // namespace kinestat
