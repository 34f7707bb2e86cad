#include "run/texts/word_mentions.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

#include "core/page_text.hpp"
#include "run/texts/library_file.hpp"

namespace kinestat {

namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  std::ranges::transform(
      result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

bool is_letter(std::string_view text, std::size_t at) {
  return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
}

// With an "s" behind it or not; neither text has capitals.
bool stands_in(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool is_plural = end < text.size() && text[end] == 's' && !is_letter(text, end + 1);
    if ((at == 0 || !is_letter(text, at - 1)) && (is_plural || !is_letter(text, end))) {
      return true;
    }
  }
  return false;
}

// The first line, without the blanks that only make columns.
std::string line_with(std::string_view text, const std::string& word) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (mentions(line, word)) {
      std::string shown;
      for (const char c : line) {
        if (c != ' ' || (!shown.empty() && shown.back() != ' ')) {
          shown += c;
        }
      }
      return shown;
    }
  }
  return {};
}

}  // namespace

bool mentions(std::string_view text, const std::string& word) {
  const std::string all = lower(text);
  const std::string wanted = lower(word);
  std::string spaced = wanted;
  std::ranges::replace(spaced, '_', ' ');
  std::ranges::replace(spaced, '-', ' ');
  const bool is_plural = wanted.size() > 3 && wanted.ends_with('s') && !wanted.ends_with("ss");
  return stands_in(all, wanted) || stands_in(all, spaced) ||
         (is_plural && stands_in(all, std::string_view(wanted).substr(0, wanted.size() - 1)));
}

std::string mentions_of(const std::string& word, const std::vector<HelpPage>& pages) {
  constexpr std::size_t kIndent = 6;
  constexpr std::size_t kWidth = 92;
  const auto below = [](std::string_view line) {
    return page_lines(std::string(kIndent, ' '), line, kIndent, kWidth);
  };
  std::string text;
  for (const HelpPage& page : pages) {
    const bool is_title = mentions(page.title, word);
    const std::string line = is_title ? "" : line_with(page.text, word);
    if (is_title || !line.empty()) {
      text += fmt::format("  {:<22} {}\n", page.command, page.title);
      text += line.empty() ? "" : below(line);
    }
  }
  for (const LibraryFile& file : library_files()) {
    if (mentions(file.title, word) || mentions(file.name, word)) {
      text += fmt::format("  examples {}\n", file.name);
      text += below(file.title);
    }
  }
  return text;
}

}  // namespace kinestat
