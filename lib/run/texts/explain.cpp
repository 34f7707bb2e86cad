#include "run/texts/explain.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/codes.hpp"
#include "core/page_text.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "run/embedded.hpp"

namespace kinestat {

namespace {

std::string upper(std::string word) {
  std::ranges::transform(word, word.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return word;
}

std::string indented(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    result += fmt::format("  {}\n", text.substr(0, end));
    text.remove_prefix(std::min(end, text.size() - 1) + 1);
  }
  return result;
}

std::string page_of(const Code& row) {
  std::string page =
      fmt::format("{}: {}\n\n{}", row.code, row.title, page_lines("", row.paragraph, 0));
  if (const EmbeddedText* example = find_text(embedded_examples(), row.code)) {
    page += fmt::format("\nExample (- wrong, + correct):\n\n{}", indented(example->text));
  }
  return page;
}

}  // namespace

bool is_code(std::string_view word) {
  constexpr std::size_t kDigits = 4;
  const bool has_letter =
      !word.empty() && std::string_view("EWew").find(word.front()) != std::string_view::npos;
  return has_letter && word.size() == kDigits + 1 &&
         word.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

Outcome explain(const std::string& code) {
  Outcome outcome;
  if (code.empty()) {
    for (const Code& row : all_codes()) {
      outcome.out += fmt::format("{}  {}\n", row.code, row.title);
    }
    return outcome;
  }
  if (const Code* row = find_code(upper(code))) {
    outcome.out = page_of(*row);
    return outcome;
  }
  std::vector<std::string> codes;
  for (const Code& row : all_codes()) {
    codes.emplace_back(row.code);
  }
  add_message("E0101",
              fmt::format("there is no code '{}'", printable(code)),
              guess_before(code, codes, "'kinestat explain' lists all"),
              outcome);
  return outcome;
}

}  // namespace kinestat
