// From byte offsets in a text to lines and columns.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/source.hpp"
#include "io/internal/yaml_text.hpp"

namespace kinestat {

/// Owns a text without its byte order mark, and finds places in it. Offsets count bytes, columns
/// count characters. Questions in rising order are cheap, also in one very long line.
class SourceMap {
 public:
  /// Drops a leading byte order mark.
  explicit SourceMap(std::string_view text);

  const YamlText& text() const { return text_; }

  /// Replaces escapes of two surrogates, "\ud83d\ude00" as JSON has them, by the characters that
  /// they are. Their offsets, rising; columns count on as before.
  void join_surrogates(std::span<const std::size_t> pairs);

  /// From `begin` to before `end`, cut at the end of the line; at least one character long.
  SourceRange range(std::size_t begin, std::size_t end);

  /// One character.
  SourceRange at(std::size_t offset) { return range(offset, offset + 1); }

  /// The offset behind the last character of the line, without its line end.
  std::size_t line_end(std::size_t offset) const;

 private:
  int line_of(std::size_t offset) const;
  int column_of(std::size_t offset, std::size_t line_start);
  int count_characters(std::size_t begin, std::size_t end) const;

  YamlText text_;
  std::vector<std::size_t> line_starts_;
  std::vector<std::size_t> joined_;  // where characters stand that were two escapes
  std::size_t last_offset_ = 0;      // where column_of counted to before, and the column there
  int last_column_ = 1;
};

}  // namespace kinestat
