#include "format/mechanism_writer.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "format/sections/sections.hpp"
#include "format/value_forms.hpp"

namespace kinestat {

namespace {

using FileEntry = std::pair<std::string, FileText>;

// In this order and without empty lines between them.
constexpr auto kHead =
    std::to_array<std::string_view>({"kinestat", "name", "source", "space", "units"});

std::string list_text(const std::vector<Value>& values) {
  std::string text;
  for (const Value& value : values) {
    text += (text.empty() ? "" : ", ") + value.expression.text();
  }
  return "[" + text + "]";
}

std::string axis_text(const AxisDescription& axis) {
  return axis.keyword == 0 ? list_text(axis.components)
                           : std::string(axis.sign < 0.0 ? "-" : "") + axis.keyword;
}

std::string coupling_text(const CouplingDescription& coupling) {
  KINESTAT_EXPECTS(coupling.type == CouplingType::revolute ||
                   coupling.type == CouplingType::prismatic);
  KINESTAT_EXPECTS(!coupling.at || coupling.at->point);
  std::string text = fmt::format("  {}: {{type: {}, bodies: [{}, {}]",
                                 coupling.name.text,
                                 word_of(coupling.type),
                                 coupling.tail.text,
                                 coupling.head.text);
  if (coupling.at) {
    text += ", at: " + list_text(coupling.at->point->coordinates);
  }
  if (coupling.axis) {
    text += ", axis: " + axis_text(*coupling.axis);
  }
  return text + "}\n";
}

std::string couplings_text(const std::vector<CouplingDescription>& couplings) {
  std::string text;
  for (const CouplingDescription& one : couplings) {
    text += coupling_text(one);
  }
  return text.empty() ? "" : "\ncouplings:\n" + text;
}

}  // namespace

std::string mechanism_text(const MechanismDescription& description,
                           std::span<const std::string> head) {
  std::string text;
  for (const std::string& line : head) {
    text += line.empty() ? "#\n" : fmt::format("# {}\n", printable(line));
  }
  const FileText file = file_sections().text(description);
  for (const std::string_view key : kHead) {
    const auto at = std::ranges::find(file.entries, key, &FileEntry::first);
    text += at != file.entries.end() ? fmt::format("{}:{}", key, behind_key(at->second, 0)) : "";
  }
  for (const auto& [key, value] : file.entries) {
    if (std::ranges::find(kHead, key) == kHead.end()) {
      text += fmt::format("\n{}:{}", key, behind_key(value, 0));
      text += key == "bodies" ? couplings_text(description.couplings) : "";
    }
  }
  return text;
}

}  // namespace kinestat
