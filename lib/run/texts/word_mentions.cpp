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

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    lines.push_back(text.substr(0, text.find('\n')));
    text.remove_prefix(std::min(text.size(), lines.back().size() + 1));
  }
  return lines;
}

std::size_t indent_of(std::string_view line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

// A line of a file or of the shell, or the key of a definition.
bool stands_alone(std::string_view line) {
  line.remove_prefix(indent_of(line));
  const std::string_view first = line.substr(0, line.find(' '));
  return line.empty() || first.ends_with(':') || first == "-" || first == "kinestat";
}

// The line and those before and after it in the same paragraph; of a definition, which begins in
// the column behind its term, what follows the term.
std::string paragraph_of(const std::vector<std::string_view>& lines, std::size_t at) {
  const std::size_t indent = indent_of(lines[at]);
  const auto belongs = [&](std::string_view line) {
    return indent_of(line) == indent && !stands_alone(line);
  };
  std::size_t first = at;
  std::size_t last = at;
  if (!stands_alone(lines[at])) {
    while (first > 0 && belongs(lines[first - 1])) {
      --first;
    }
    while (last + 1 < lines.size() && belongs(lines[last + 1])) {
      ++last;
    }
  }
  std::string text;
  if (first > 0 && indent > 2 && lines[first - 1].size() > indent &&
      indent_of(lines[first - 1]) < indent && lines[first - 1].substr(indent - 2, 2) == "  ") {
    text = std::string(lines[first - 1].substr(indent)) + " ";
  }
  for (std::size_t i = first; i <= last; ++i) {
    text += std::string(lines[i]) + " ";
  }
  return text;
}

// The first sentence, without the blanks that only make columns.
std::string sentence_with(std::string_view text, const std::string& word) {
  const std::vector<std::string_view> lines = lines_of(text);
  const auto line =
      std::ranges::find_if(lines, [&](std::string_view one) { return mentions(one, word); });
  if (line == lines.end()) {
    return {};
  }
  std::string shown;
  for (const char c : paragraph_of(lines, static_cast<std::size_t>(line - lines.begin()))) {
    if (c != ' ' || (!shown.empty() && shown.back() != ' ')) {
      shown += c;
    }
    if (shown.ends_with(". ")) {
      if (mentions(shown, word)) {
        break;
      }
      shown.clear();
    }
  }
  shown.erase(shown.find_last_not_of(' ') + 1);
  return shown;
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
  const auto below = [](std::string_view line) {
    return page_lines(std::string(kIndent, ' '), line, kIndent);
  };
  std::string text;
  for (const HelpPage& page : pages) {
    const bool is_title = mentions(page.title, word);
    const std::string line = is_title ? "" : sentence_with(page.text, word);
    if (is_title || !line.empty()) {
      text += page_lines(fmt::format("  {:<22} ", page.command), page.title, 25);
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
