// A report for people before it is laid out: lines of text and tables, in reading order.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/column_table.hpp"
#include "report/table.hpp"
#include "report/text_layout.hpp"

namespace kinestat {

/// Lines of text, or a table.
struct TextBlock {
  std::string lines;  ///< each with its line end; empty for a table
  std::optional<Table> table;
  std::string indent;    ///< before every line of the table, as text
  std::size_t hang = 0;  ///< of lines of a list: the column in which those too long go on
};

/// Blocks in reading order. What stands on a terminal and on a page is made of the same ones. Lines
/// that are not indented are headings.
class TextBlocks {
 public:
  TextBlocks() = default;

  explicit TextBlocks(std::string_view lines) { *this += lines; }

  /// A table; as text each of its lines begins with `indent`.
  TextBlocks(Table table, std::string indent);

  /// A table that as text is indented by two spaces, and followed by an empty line.
  explicit TextBlocks(Table table);

  /// The same of columns, which must have the same number of cells.
  explicit TextBlocks(std::vector<TextColumn> columns) : TextBlocks(table_of(std::move(columns))) {}

  /// Lines, each with its line end; those that follow each other are one block.
  TextBlocks& operator+=(std::string_view lines);

  TextBlocks& operator+=(TextBlocks more);

  /// Lines of a list, none of them a heading, whose words begin in the column `hang`.
  TextBlocks& add_list(std::string_view lines, std::size_t hang);

  const std::vector<TextBlock>& blocks() const { return blocks_; }

  bool is_empty() const { return blocks_.empty(); }

  /// All of it as text. Lines longer than the layout is wide go on below, indented further; tables
  /// too wide are parted after a column.
  std::string text(const TextLayout& layout = {}) const;

 private:
  std::vector<TextBlock> blocks_;
};

}  // namespace kinestat
