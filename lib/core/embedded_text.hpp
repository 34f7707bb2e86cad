// A text that the build puts into the program: a schema, a starter file, a page of help.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kinestat {

/// One file, byte for byte; kinestat_embed of lib/CMakeLists.txt writes the tables.
struct EmbeddedText {
  std::string_view name;  ///< the file's name up to its first dot, perhaps with its folder
  std::string_view text;
};

/// The text of that name, or null.
inline const EmbeddedText* find_text(std::span<const EmbeddedText> texts, std::string_view name) {
  const auto at = std::ranges::find(texts, name, &EmbeddedText::name);
  return at == texts.end() ? nullptr : &*at;
}

inline std::vector<std::string> names_of(std::span<const EmbeddedText> texts) {
  std::vector<std::string> names;
  for (const EmbeddedText& one : texts) {
    names.emplace_back(one.name);
  }
  return names;
}

}  // namespace kinestat
