// Descriptions from the text of a file, with what the readers complained of.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "io/yaml_tree.hpp"

namespace kinestat {

/// "3:5 E0302 mesh 'h' has no key 'carier'": place, code and message of each.
inline std::vector<std::string> complaints_of(const Diagnostics& found) {
  std::vector<std::string> complaints;
  for (const Diagnostic& one : found.items()) {
    complaints.push_back(
        fmt::format("{}:{} {} {}", one.where.line, one.where.column, one.code, one.message));
  }
  return complaints;
}

/// What a reader of a section makes of a text that is the section alone.
template <class Result>
struct Reading {
  Result value;
  Diagnostics found;

  std::vector<std::string> complaints() const { return complaints_of(found); }
};

/// `read` takes the root of the text and the diagnostics.
template <class Read>
auto read_text(const std::string& text, Read read) {
  using Result = decltype(read(YamlNode(), std::declval<Diagnostics&>()));
  Reading<Result> reading;
  const auto root = read_yaml({.path = "test.yaml", .text = text}, ReadLimits{}, reading.found);
  if (root) {
    reading.value = read(*root, reading.found);
  }
  return reading;
}

using Complaints = std::vector<std::string>;

}  // namespace kinestat
