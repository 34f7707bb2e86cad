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
#include "forms/value_forms.hpp"

namespace kinestat {

namespace {

using FileEntry = std::pair<std::string, FileText>;

// In this order and without empty lines between them.
constexpr auto kHead =
    std::to_array<std::string_view>({"kinestat", "name", "source", "space", "units"});

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
    }
  }
  return text;
}

}  // namespace kinestat
