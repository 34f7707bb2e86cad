#include "report/text_blocks.hpp"

#include <utility>

namespace kinestat {

TextBlocks::TextBlocks(Table table, std::string indent) {
  blocks_.push_back({.lines = {}, .table = std::move(table), .indent = std::move(indent)});
}

TextBlocks::TextBlocks(Table table) : TextBlocks(std::move(table), "  ") {
  *this += "\n";
}

TextBlocks& TextBlocks::operator+=(std::string_view lines) {
  if (lines.empty()) {
    return *this;
  }
  if (blocks_.empty() || blocks_.back().table) {
    blocks_.push_back({.lines = {}, .table = std::nullopt, .indent = {}});
  }
  blocks_.back().lines += lines;
  return *this;
}

TextBlocks& TextBlocks::operator+=(TextBlocks more) {
  for (TextBlock& one : more.blocks_) {
    if (one.table) {
      blocks_.push_back(std::move(one));
    } else {
      *this += one.lines;
    }
  }
  return *this;
}

std::string TextBlocks::text() const {
  std::string text;
  for (const TextBlock& one : blocks_) {
    text += one.table ? one.table->text(one.indent) : one.lines;
  }
  return text;
}

}  // namespace kinestat
