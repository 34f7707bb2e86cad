#include "description/value.hpp"

#include <algorithm>

#include "core/utf8.hpp"

namespace kinestat {

namespace {

// Characters among the first `bytes` bytes.
int characters(std::string_view text, int bytes) {
  const std::string_view part = text.substr(0, static_cast<std::size_t>(std::max(bytes, 0)));
  return static_cast<int>(count_characters(part));
}

}  // namespace

SourceRange place_in(
    SourceRange where, int text_column, std::string_view text, int offset, int length) {
  if (text_column == 0 || (offset == 0 && length == 0)) {
    return where;
  }
  const int before = characters(text, offset);
  const int marked = characters(text, offset + length) - before;
  return {.line = where.line, .column = text_column + before, .length = std::max(marked, 1)};
}

SourceRange place_in(const Value& value, const ExpressionError& error) {
  return place_in(
      value.where, value.text_column, value.expression.text(), error.offset, error.length);
}

}  // namespace kinestat
