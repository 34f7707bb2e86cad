// Reads small YAML texts in tests.
#pragma once

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "io/yaml_tree.hpp"

namespace kinestat {

inline std::string place(SourceRange where) {
  return fmt::format("{}:{}+{}", where.line, where.column, where.length);
}

// "E0204 2:3+1 message (note 1:1+1 message)", one line a diagnostic.
inline std::string complaints(const std::string& text, const ReadLimits& limits = {}) {
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

inline YamlNode read(const std::string& text) {
  Diagnostics found;
  auto root = read_yaml({.path = "test.yaml", .text = text}, {}, found);
  EXPECT_FALSE(found.has_errors()) << (found.has_errors() ? found.items()[0].message : "");
  return root.value_or(YamlNode{});
}

// The value of key 'a', which the text must have.
inline YamlNode value_of(const std::string& text) {
  const YamlNode root = read(text);
  const YamlNode* const value = root.find("a");
  EXPECT_NE(value, nullptr);
  return value == nullptr ? YamlNode{} : *value;
}

/// A text and what is expected of it.
struct YamlCase {
  std::string name;
  std::string text;
  std::string expected;
};

inline std::string name_of_case(const testing::TestParamInfo<YamlCase>& info) {
  return info.param.name;
}

}  // namespace kinestat
