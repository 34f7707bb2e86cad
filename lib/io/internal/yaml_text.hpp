// The questions that YAML's grammar asks of the characters at an offset.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace kinestat {

inline bool is_one_of(char c, std::string_view set) {
  return c != '\0' && set.find(c) != std::string_view::npos;
}

/// A text that may be asked about any offset; behind its end stand zeros.
class YamlText {
 public:
  explicit YamlText(std::string text) : text_(std::move(text)) {}

  const std::string& all() const { return text_; }

  /// From one offset to before another.
  std::string_view part(std::size_t begin, std::size_t end) const {
    return std::string_view(text_).substr(std::min(begin, text_.size()), end - begin);
  }

  bool is_end(std::size_t at) const { return at >= text_.size(); }

  char operator[](std::size_t at) const { return is_end(at) ? '\0' : text_[at]; }

  bool is_blank(std::size_t at) const { return (*this)[at] == ' ' || (*this)[at] == '\t'; }

  /// Length of the line end at the offset; 0 where none is.
  std::size_t line_break(std::size_t at) const {
    if ((*this)[at] == '\n') {
      return 1;
    }
    return (*this)[at] == '\r' && (*this)[at + 1] == '\n' ? 2 : 0;
  }

  bool is_space(std::size_t at) const { return is_blank(at) || line_break(at) > 0; }

  bool is_space_or_end(std::size_t at) const { return is_end(at) || is_space(at); }

  /// A space or line end with the comment sign right behind it.
  bool is_comment_start(std::size_t at) const {
    const std::size_t size = is_blank(at) ? 1 : line_break(at);
    return size > 0 && (*this)[at + size] == '#';
  }

  /// "---" or "..." on its own, where a line begins.
  bool is_document_mark(std::size_t at) const {
    if (at > 0 && (*this)[at - 1] != '\n') {
      return false;
    }
    const std::string_view mark = part(at, at + 3);
    return (mark == "---" || mark == "...") && is_space_or_end(at + 3);
  }

  /// The offset of the line's end.
  std::size_t skip_line(std::size_t at) const {
    while (!is_end(at) && line_break(at) == 0) {
      ++at;
    }
    return at;
  }

  /// Behind the characters that are no space and no flow indicator.
  std::size_t skip_word(std::size_t at) const {
    while (!is_space_or_end(at) && !is_one_of((*this)[at], "[]{},")) {
      ++at;
    }
    return at;
  }

  std::size_t skip_blanks(std::size_t at) const {
    while (is_blank(at)) {
      ++at;
    }
    return at;
  }

 private:
  std::string text_;
};

}  // namespace kinestat
