#include "fuzz/diagnostic_invariants.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/codes.hpp"
#include "core/utf8.hpp"
#include "fuzz/require.hpp"

namespace kinestat::fuzz {

namespace {

bool is_character_start(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

void check_words(std::string_view words, std::string_view what) {
  require(printable(words) == words, fmt::format("{} is one line of printable text", what), words);
}

}  // namespace

LineLengths::LineLengths(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) {
    text.remove_prefix(kByteOrderMark.size());
  }
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    lengths_.push_back(static_cast<int>(std::ranges::count_if(line, is_character_start)));
    begin = end + 1;
  }
}

bool LineLengths::holds(const SourceRange& where) const {
  if (where.line == 0) {
    return where.column == 0;
  }
  if (where.line < 1 || where.line > static_cast<int>(lengths_.size())) {
    return false;
  }
  const int length = lengths_[static_cast<std::size_t>(where.line) - 1];
  return where.column >= 1 && where.length >= 1 && where.column + where.length - 1 <= length + 1;
}

void check_diagnostics(const Diagnostics& found, const LineLengths& lines) {
  for (const Diagnostic& item : found.items()) {
    const std::string evidence = fmt::format("{}:{}+{} {} {}",
                                             item.where.line,
                                             item.where.column,
                                             item.where.length,
                                             item.code,
                                             printable(item.message));
    require(find_code(item.code) != nullptr, "the code is known", evidence);
    require(lines.holds(item.where), "the place lies in the text", evidence);
    require(!item.message.empty(), "there is a message", evidence);
    check_words(item.message, "a message");
    check_words(item.hint, "a hint");
    for (const Note& note : item.notes) {
      require(lines.holds(note.where), "the place of a note lies in the text", note.message);
      check_words(note.message, "a note");
    }
  }
}

void check_error(const ExpressionError& error, std::string_view text) {
  const auto evidence = [&] {
    return fmt::format("{}+{} {} {}", error.offset, error.length, error.code, error.message);
  };
  const int size = static_cast<int>(text.size());
  require(find_code(error.code) != nullptr, "the code is known", evidence);
  require(error.offset >= 0 && error.offset <= size, "the offset lies in the text", evidence);
  require(error.length >= 0 && error.length <= size - error.offset,
          "the error ends in the text",
          evidence);
  require(!error.message.empty(), "there is a message", evidence);
}

}  // namespace kinestat::fuzz
