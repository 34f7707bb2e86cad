#include "report/styled_text.hpp"

#include <fmt/format.h>

namespace kinestat {

namespace {

// Parameters of SELECT GRAPHIC RENDITION (ECMA-48, 8.3.117): 1 bold, 31 red, 33 yellow, 36 cyan.
std::string_view rendition(LineStyle style) {
  switch (style) {
    case LineStyle::heading:
      return "1";
    case LineStyle::error:
      return "1;31";
    case LineStyle::warning:
      return "1;33";
    case LineStyle::hint:
      return "36";
  }
  return "0";
}

}  // namespace

std::string styled(std::string_view text, LineStyle style) {
  return fmt::format("\x1b[{}m{}\x1b[0m", rendition(style), text);
}

StyledText& StyledText::operator+=(const std::string& plain) {
  text_ += plain;
  return *this;
}

StyledText& StyledText::operator+=(const StyledText& more) {
  for (Span span : more.spans_) {
    span.begin += text_.size();
    spans_.push_back(span);
  }
  text_ += more.text_;
  return *this;
}

void StyledText::add(std::string_view text, LineStyle style) {
  spans_.push_back({.begin = text_.size(), .size = text.size(), .style = style});
  text_ += text;
}

std::string StyledText::coloured() const {
  std::string result;
  std::size_t done = 0;
  for (const Span& span : spans_) {
    result += text_.substr(done, span.begin - done);
    result += styled(text_.substr(span.begin, span.size), span.style);
    done = span.begin + span.size;
  }
  return result + text_.substr(done);
}

}  // namespace kinestat
