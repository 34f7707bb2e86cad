#include "forms/file_text.hpp"

#include <fmt/format.h>

#include "core/utf8.hpp"

namespace kinestat {

namespace {

// Lists and mappings in brackets.
std::string on_one_line(const FileText& value) {
  std::string text;
  for (const FileText& item : value.items) {
    text += (text.empty() ? "" : ", ") + on_one_line(item);
  }
  for (const auto& [key, item] : value.entries) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", key, on_one_line(item));
  }
  switch (value.kind) {
    case FileText::Kind::single:
      return value.single;
    case FileText::Kind::list:
      return "[" + text + "]";
    case FileText::Kind::mapping:
      return "{" + text + "}";
  }
  return text;
}

}  // namespace

FileText single_text(std::string text) {
  return {.single = std::move(text)};
}

FileText expression_text(std::string_view expression) {
  const bool is_plain = expression.find_first_of(",[]{}#:\"") == std::string_view::npos;
  return single_text(is_plain ? std::string(expression) : in_quotes(expression));
}

FileText list_text(std::vector<FileText> items) {
  return {.kind = FileText::Kind::list, .items = std::move(items)};
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : printable(text)) {
    result += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  }
  return result + "\"";
}

std::string behind_key(const FileText& value, int indent) {
  if (!value.in_lines || value.entries.empty()) {
    const std::string text = on_one_line(value);
    return (text.empty() ? "" : " ") + text + "\n";
  }
  constexpr int kStep = 2;
  std::string text = "\n";
  for (const auto& [key, item] : value.entries) {
    text += fmt::format("{:{}}{}:{}", "", indent + kStep, key, behind_key(item, indent + kStep));
  }
  return text;
}

}  // namespace kinestat
