#include "core/page_text.hpp"

#include <algorithm>

#include "core/utf8.hpp"

namespace kinestat {

std::string page_lines(std::string_view head,
                       std::string_view words,
                       std::size_t begin,
                       std::size_t width) {
  std::string text;
  std::string line(head);
  bool is_first = true;  // of its line
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(' '));
    words.remove_prefix(std::min(words.size(), word.size() + 1));
    if (!is_first && columns_of(line) + 1 + columns_of(word) > width) {
      text += line + "\n";
      line.clear();
      is_first = true;
    }
    line.append(is_first ? begin - std::min(begin, columns_of(line)) : 1, ' ').append(word);
    is_first = false;
  }
  return text + line + "\n";
}

}  // namespace kinestat
