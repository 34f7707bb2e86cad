// One line of the text, and the keys that begin it.
#pragma once

#include <cstddef>
#include <string>

#include "io/internal/yaml_text.hpp"

namespace kinestat {

/// Offsets: of its begin, behind the blanks before its content, and before its line end.
struct TextLine {
  std::size_t start = 0;
  std::size_t content = 0;
  std::size_t end = 0;

  bool is_empty() const { return content == end; }

  std::size_t indentation() const { return content - start; }
};

inline TextLine line_at(const YamlText& text, std::size_t at) {
  const std::size_t before = at == 0 ? std::string::npos : text.all().rfind('\n', at - 1);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  const std::size_t content = text.skip_blanks(start);
  return {.start = start, .content = content, .end = text.skip_line(content)};
}

/// Behind a key of one word, before its ':'.
inline std::size_t skip_key(const YamlText& text, std::size_t at) {
  while (!text.is_space_or_end(at) && !is_one_of(text[at], ":[]{},")) {
    ++at;
  }
  return at;
}

/// Where the value of the key begins that stands at the offset; npos if none does.
inline std::size_t find_value(const YamlText& text, std::size_t key) {
  const std::size_t end = skip_key(text, key);
  return end > key && text[end] == ':' && text.is_blank(end + 1) ? text.skip_blanks(end + 1)
                                                                 : std::string::npos;
}

}  // namespace kinestat
