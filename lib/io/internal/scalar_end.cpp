#include "io/internal/scalar_end.hpp"

#include <algorithm>
#include <string_view>

namespace kinestat {

namespace {

bool is_plain_end(const YamlText& text, std::size_t at, Context context) {
  const char c = text[at];
  if (text.is_comment_start(at) || (c == ':' && text.is_space_or_end(at + 1))) {
    return true;
  }
  return context == Context::in_brackets &&
         (is_one_of(c, ",?[]{}") || (c == ':' && is_one_of(text[at + 1], ",]}")));
}

// The rest of the scalar on one line.
std::size_t find_line_of_plain_end(const YamlText& text, std::size_t at, Context context) {
  while (!text.is_end(at) && !is_plain_end(text, at, context) && text.line_break(at) == 0 &&
         !text.is_document_mark(at)) {
    ++at;
  }
  return at;
}

bool is_tag_character(char c) {
  const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return is_letter || (c >= '0' && c <= '9') || is_one_of(c, "-#;/?:@&=+$_.~*'()!%<>");
}

struct BlockHeader {
  std::size_t end = 0;
  int indent = 0;  // 0: the first line shows it
};

BlockHeader read_block_header(const YamlText& text, std::size_t begin) {
  BlockHeader header = {.end = begin + 1};
  while (is_one_of(text[header.end], "+-123456789")) {
    if (is_one_of(text[header.end], "123456789")) {
      header.indent = text[header.end] - '0';
    }
    ++header.end;
  }
  header.end = text.skip_blanks(header.end);
  if (text[header.end] == '#') {
    header.end = text.skip_line(header.end);
  }
  return header;
}

}  // namespace

bool is_plain_start(const YamlText& text, std::size_t at, Context context) {
  const bool in_brackets = context == Context::in_brackets;
  if (is_one_of(text[at], ",[]{}#&*!|>'\"%@`") || (text[at] == '?' && in_brackets)) {
    return false;
  }
  if (!is_one_of(text[at], "-?:")) {
    return true;
  }
  return in_brackets ? !text.is_blank(at + 1) && !text.is_end(at + 1)
                     : !text.is_space_or_end(at + 1);
}

std::size_t find_name_end(const YamlText& text, std::size_t begin) {
  if (text[begin] != '!') {
    return text.skip_word(begin + 1);
  }
  std::size_t at = begin + 1;
  while (is_tag_character(text[at])) {
    ++at;
  }
  return at;
}

std::size_t find_quote_end(const YamlText& text, std::size_t begin) {
  const char quote = text[begin];
  std::size_t at = begin + 1;
  while (!text.is_end(at) && !text.is_document_mark(at)) {
    const bool is_escape =
        quote == '"' ? text[at] == '\\' : text[at] == '\'' && text[at + 1] == '\'';
    if (!is_escape && text[at] == quote) {
      return at + 1;
    }
    at += is_escape ? 2 : 1;
  }
  return std::string_view::npos;
}

ScalarEnd find_plain_end(const YamlText& text, std::size_t begin, int indent, Context context) {
  std::size_t at = begin;
  while (true) {
    at = find_line_of_plain_end(text, at, context);
    if (text.line_break(at) == 0 || is_plain_end(text, at, context)) {
      return {.offset = at};
    }
    at += text.line_break(at);
    const std::size_t first_column = at + static_cast<std::size_t>(indent);
    const std::size_t tab = text.part(at, first_column).find_first_not_of(' ');
    if (tab != std::string_view::npos && text[at + tab] == '\t') {
      return {.offset = at + tab, .is_at_tab = true};
    }
    while (text.is_blank(at) && !is_plain_end(text, at, context)) {
      ++at;
    }
    if (text.line_break(at) == 0 && at < first_column) {
      return {.offset = at};
    }
  }
}

ScalarEnd find_block_scalar_end(const YamlText& text, std::size_t begin, int block_column) {
  const BlockHeader header = read_block_header(text, begin);
  bool is_detecting = header.indent == 0;
  auto indent = static_cast<std::size_t>(std::max(header.indent, 1) + block_column);
  std::size_t at = header.end;
  while (text.line_break(at) > 0) {
    at += text.line_break(at);
    const std::size_t line_start = at;
    while (text[at] == ' ' && (at < line_start + indent || is_detecting)) {
      ++at;
    }
    indent = is_detecting ? std::max(indent, at - line_start) : indent;
    if (text[at] == '\t' && at < line_start + indent) {
      return {.offset = at, .is_at_tab = true};
    }
    if (text.line_break(at) > 0) {
      continue;
    }
    if (at < line_start + indent) {
      return {.offset = at};
    }
    is_detecting = false;
    at = text.skip_line(at);
  }
  return {.offset = at};
}

}  // namespace kinestat
