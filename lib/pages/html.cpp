#include "pages/html.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "draw/markup.hpp"

namespace kinestat {

namespace {

// After the end of any other element a line may end.
bool is_within_lines(std::string_view name) {
  constexpr auto kNames = std::to_array<std::string_view>(
      {"a", "b", "button", "code", "label", "option", "output", "span", "strong"});
  return std::ranges::find(kNames, name) != kNames.end();
}

// Those that end where the next begins, or what they stand in, as HTML has it.
bool ends_by_itself(std::string_view name) {
  constexpr auto kNames = std::to_array<std::string_view>({"td", "th", "tr", "tbody", "thead"});
  return std::ranges::find(kNames, name) != kNames.end();
}

}  // namespace

void Html::begin(std::string_view name, Attributes attributes) {
  html_ += fmt::format("<{}", name);
  for (const auto& [key, value] : attributes) {
    html_ += value.empty() ? fmt::format(" {}", key)
                           : fmt::format(" {}=\"{}\"", key, escape_markup(value));
  }
  html_ += ">";
}

void Html::open(std::string_view name, Attributes attributes) {
  begin(name, attributes);
  open_.emplace_back(name);
}

void Html::close() {
  KINESTAT_EXPECTS(!open_.empty());
  if (!ends_by_itself(open_.back())) {
    html_ += fmt::format("</{}>{}", open_.back(), is_within_lines(open_.back()) ? "" : "\n");
  }
  open_.pop_back();
}

void Html::element(std::string_view name, std::string_view text, Attributes attributes) {
  open(name, attributes);
  this->text(text);
  close();
}

void Html::single(std::string_view name, Attributes attributes) {
  begin(name, attributes);
}

void Html::text(std::string_view text) {
  html_ += escape_markup(text);
}

void Html::lines(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    this->text(text.substr(0, end));
    if (end < text.size()) {
      html_ += "\n";
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

const std::string& Html::html() const {
  KINESTAT_EXPECTS(open_.empty());
  return html_;
}

std::string script_json(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  while (!json.empty()) {
    const std::size_t end = std::min(json.find('<'), json.size());
    text += json.substr(0, end);
    text += end < json.size() ? "\\u003c" : "";
    json.remove_prefix(std::min(end + 1, json.size()));
  }
  return text;
}

std::string script_string(std::string_view text) {
  std::string json = "\"";
  json.reserve(text.size() + text.size() / 8);
  for (const char character : text) {
    const auto code = static_cast<unsigned char>(character);
    if (character == '"' || character == '\\') {
      json += '\\';
      json += character;
    } else if (character == '\n') {
      json += "\\n";
    } else if (code < 0x20 || character == '<') {
      json += fmt::format("\\u{:04x}", code);
    } else {
      json += character;
    }
  }
  return json + "\"";
}

}  // namespace kinestat
