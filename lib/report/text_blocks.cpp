#include "report/text_blocks.hpp"

#include <algorithm>
#include <utility>

#include "core/utf8.hpp"
#include "report/styled_text.hpp"

namespace kinestat {

namespace {

// Where a line is broken that is too wide: at the last space that leaves it within, or the first
// one if none does. The end if it stays as it is.
std::size_t end_within(std::string_view line, std::size_t begin, std::size_t width) {
  std::size_t end = line.size();
  for (std::size_t at = line.find(' ', begin); at != std::string_view::npos;
       at = line.find(' ', at + 1)) {
    if (end < line.size() && columns_of(line.substr(0, at)) > width) {
      break;
    }
    end = at;
  }
  return end;
}

std::string wrapped(std::string_view line, std::size_t width, std::size_t hang) {
  constexpr std::size_t kFurther = 2;
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  const std::string below(hang > 0 ? hang : indent + kFurther, ' ');
  std::string text;
  std::string rest(line);
  while (width > 0 && columns_of(rest) > width) {
    const std::size_t words = rest.find_first_not_of(' ');
    const std::size_t end = end_within(rest, words, width);
    if (end >= rest.size()) {
      break;
    }
    text += rest.substr(0, end) + "\n";
    rest = below + rest.substr(end + 1);
  }
  return text + rest;
}

std::string laid_out(std::string_view lines, const TextLayout& layout, std::size_t hang) {
  std::string text;
  for (std::size_t at = 0; at < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', at), lines.size());
    const std::string_view line = lines.substr(at, end - at);
    const bool is_heading = hang == 0 && !line.empty() && line.front() != ' ';
    const std::string shown = wrapped(line, layout.width, hang);
    text += layout.is_coloured && is_heading ? styled(shown, LineStyle::heading) : shown;
    text += end < lines.size() ? "\n" : "";
    at = end + 1;
  }
  return text;
}

}  // namespace

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
  if (blocks_.empty() || blocks_.back().table || blocks_.back().hang > 0) {
    blocks_.push_back({.lines = {}, .table = std::nullopt, .indent = {}});
  }
  blocks_.back().lines += lines;
  return *this;
}

TextBlocks& TextBlocks::add_list(std::string_view lines, std::size_t hang) {
  blocks_.push_back(
      {.lines = std::string(lines), .table = std::nullopt, .indent = {}, .hang = hang});
  return *this;
}

TextBlocks& TextBlocks::operator+=(TextBlocks more) {
  for (TextBlock& one : more.blocks_) {
    if (one.table || one.hang > 0) {
      blocks_.push_back(std::move(one));
    } else {
      *this += one.lines;
    }
  }
  return *this;
}

std::string TextBlocks::text(const TextLayout& layout) const {
  std::string text;
  for (const TextBlock& one : blocks_) {
    text += one.table ? one.table->text(one.indent, layout) : laid_out(one.lines, layout, one.hang);
  }
  return text;
}

}  // namespace kinestat
