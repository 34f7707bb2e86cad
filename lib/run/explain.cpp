#include "run/explain.hpp"

#include <fmt/format.h>

#include "core/codes.hpp"
#include "core/text.hpp"

namespace kinestat {

namespace {

// Breaks a paragraph into lines of at most 80 characters.
std::string wrapped(std::string_view paragraph) {
  constexpr std::size_t kWidth = 80;
  std::string text;
  std::size_t length = 0;
  while (!paragraph.empty()) {
    const std::string_view word = paragraph.substr(0, paragraph.find(' '));
    paragraph.remove_prefix(std::min(word.size() + 1, paragraph.size()));
    const bool fits = length + word.size() + 1 <= kWidth;
    text += text.empty() ? "" : (fits ? " " : "\n");
    length = fits || text.empty() ? length + word.size() + 1 : word.size();
    text += word;
  }
  return text + "\n";
}

}  // namespace

Outcome explain(const std::string& code) {
  Outcome outcome;
  if (code.empty()) {
    for (const Code& row : all_codes()) {
      outcome.out += fmt::format("{}  {}\n", row.code, row.title);
    }
    return outcome;
  }
  if (const Code* row = find_code(code)) {
    outcome.out = fmt::format("{}: {}\n\n{}", row->code, row->title, wrapped(row->paragraph));
    return outcome;
  }
  std::vector<std::string> codes;
  for (const Code& row : all_codes()) {
    codes.emplace_back(row.code);
  }
  const std::string guess = did_you_mean(code, codes);
  outcome.err = fmt::format("kinestat: error[E0101]: there is no code '{}'\n  hint: {}{}\n",
                            code,
                            guess.empty() ? "" : guess + " ",
                            "'kinestat explain' lists all");
  outcome.status = ExitStatus::usage;
  return outcome;
}

}  // namespace kinestat
