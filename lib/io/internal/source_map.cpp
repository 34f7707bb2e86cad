#include "io/internal/source_map.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/utf8.hpp"
#include "io/internal/surrogates.hpp"

namespace kinestat {

namespace {

std::vector<std::size_t> find_line_starts(const std::string& text) {
  std::vector<std::size_t> starts = {0};
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
    starts.push_back(at + 1);
  }
  return starts;
}

}  // namespace

SourceMap::SourceMap(std::string_view text)
    : text_(std::string(text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size())
                                                         : text)),
      line_starts_(find_line_starts(text_.all())) {}

void SourceMap::join_surrogates(std::span<const std::size_t> pairs) {
  if (pairs.empty()) {
    return;
  }
  std::string joined;
  std::size_t done = 0;
  for (const std::size_t pair : pairs) {
    joined += text_.part(done, pair);
    joined_.push_back(joined.size());
    joined += utf8_of(code_of_surrogates(text_, pair));
    done = pair + kSurrogatesSize;
  }
  joined += text_.part(done, text_.all().size());
  text_ = YamlText(std::move(joined));
  line_starts_ = find_line_starts(text_.all());
}

int SourceMap::count_characters(std::size_t begin, std::size_t end) const {
  const std::string_view part = text_.part(begin, end);
  const auto joined =
      std::ranges::lower_bound(joined_, end) - std::ranges::lower_bound(joined_, begin);
  return static_cast<int>(std::ranges::count_if(part, begins_character) +
                          joined * (static_cast<std::ptrdiff_t>(kSurrogatesSize) - 1));
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
    last_column_ = is_near ? last_column_ - count_characters(offset, last_offset_)
                           : 1 + count_characters(line_start, offset);
  } else {
    last_column_ += count_characters(last_offset_, offset);
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
          .length = std::max(1, count_characters(first, last))};
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
