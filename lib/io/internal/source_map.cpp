#include "io/internal/source_map.hpp"

#include <algorithm>
#include <utility>

#include "core/utf8.hpp"

namespace kinestat {

namespace {

int count_characters(const std::string& text, std::size_t begin, std::size_t end) {
  const auto first = text.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = text.begin() + static_cast<std::ptrdiff_t>(end);
  return static_cast<int>(std::count_if(first, last, begins_character));
}

}  // namespace

SourceMap::SourceMap(std::string_view text)
    : text_(std::string(text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size())
                                                         : text)),
      line_starts_({0}) {
  for (std::size_t at = text_.all().find('\n'); at != std::string::npos;
       at = text_.all().find('\n', at + 1)) {
    line_starts_.push_back(at + 1);
  }
}

int SourceMap::line_of(std::size_t offset) const {
  const auto after = std::ranges::upper_bound(line_starts_, offset);
  return static_cast<int>(after - line_starts_.begin());
}

int SourceMap::column_of(std::size_t offset, std::size_t line_start) {
  if (last_offset_ < line_start || last_offset_ > offset) {
    // Going back a little is common (a null cites its key), going back to the start is not.
    const bool is_near = last_offset_ > offset && last_offset_ - offset < offset - line_start &&
                         line_of(last_offset_) == line_of(offset);
    last_column_ = is_near ? last_column_ - count_characters(text_.all(), offset, last_offset_)
                           : 1 + count_characters(text_.all(), line_start, offset);
  } else {
    last_column_ += count_characters(text_.all(), last_offset_, offset);
  }
  last_offset_ = offset;
  return last_column_;
}

SourceRange SourceMap::range(std::size_t begin, std::size_t end) {
  const std::size_t first = std::min(begin, text_.all().size());
  const int line = line_of(first);
  const std::size_t line_start = line_starts_[static_cast<std::size_t>(line) - 1];
  const std::size_t last = std::clamp(std::min(end, line_end(first)), first, text_.all().size());
  return {.line = line,
          .column = column_of(first, line_start),
          .length = std::max(1, count_characters(text_.all(), first, last))};
}

std::size_t SourceMap::line_end(std::size_t offset) const {
  const auto next = static_cast<std::size_t>(line_of(offset));
  std::size_t end = next < line_starts_.size() ? line_starts_[next] - 1 : text_.all().size();
  if (end > offset && text_[end - 1] == '\r') {
    --end;
  }
  return end;
}

}  // namespace kinestat
