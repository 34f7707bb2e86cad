#include "io/cut_value.hpp"

#include <algorithm>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "description/value.hpp"

namespace kinestat {

namespace {

// Parentheses that stay open; negative if more are closed than opened.
std::ptrdiff_t open_parentheses(std::string_view text) {
  return std::ranges::count(text, '(') - std::ranges::count(text, ')');
}

bool is_piece(const YamlNode& node) {
  return node.kind == YamlKind::scalar && !node.quoted;
}

// How many items from the first on make a value whose parentheses are closed; 0 if none do.
std::size_t count_pieces(std::span<const YamlNode> items) {
  constexpr std::size_t kMostPieces = 16;
  std::ptrdiff_t open = 0;
  for (std::size_t i = 0; i < std::min(items.size(), kMostPieces) && is_piece(items[i]); ++i) {
    open += open_parentheses(items[i].text);
    if (open <= 0) {
      return open == 0 ? i + 1 : 0;
    }
  }
  return 0;
}

std::string joined(std::span<const YamlNode> pieces) {
  std::string text;
  for (const YamlNode& piece : pieces) {
    text += text.empty() ? "" : ", ";
    text += piece.text;
  }
  return text;
}

// From the first piece to the last, if they stand on one line.
SourceRange place_of(std::span<const YamlNode> pieces) {
  SourceRange where = pieces.front().where;
  const SourceRange& last = pieces.back().where;
  if (where.line == last.line) {
    where.length = last.column + last.length - where.column;
  }
  return where;
}

// How many digits a text begins with, or ends in.
std::size_t leading_digits(std::string_view text) {
  return std::min(text.find_first_not_of("0123456789"), text.size());
}

bool ends_in_digit(std::string_view text) {
  return !text.empty() && leading_digits(text.substr(text.size() - 1)) == 1;
}

}  // namespace

void report_decimal_commas(const YamlNode& node, Diagnostics& found) {
  for (const YamlNode& item : node.items) {
    report_decimal_commas(item, found);
  }
  for (std::size_t i = 0; i < node.entries.size(); ++i) {
    const YamlEntry& entry = node.entries[i];
    report_decimal_commas(entry.value, found);
    if (i == 0 || entry.value.kind != YamlKind::null || leading_digits(entry.key) == 0) {
      continue;
    }
    const YamlNode& before = node.entries[i - 1].value;
    const bool is_beside = before.where.line == entry.key_where.line &&
                           before.where.column + before.where.length + 1 == entry.key_where.column;
    if (!is_piece(before) || !is_beside || !ends_in_digit(before.text) ||
        open_parentheses(before.text) != 0) {
      continue;
    }
    const std::size_t digits = leading_digits(entry.key);
    const std::string decimals = entry.key.substr(0, digits);
    SourceRange where = before.where;
    where.length += 1 + static_cast<int>(digits);
    found.error("E0308",
                where,
                fmt::format("'{},{}' has a decimal comma", before.text, decimals),
                fmt::format("write {}.{}, or [{}, {}] for two components",
                            before.text,
                            entry.key,
                            before.text,
                            entry.key));
  }
}

bool report_cut_value(const YamlNode& list, Diagnostics& found) {
  bool is_cut = false;
  for (std::size_t i = 0; i < list.items.size();) {
    const std::span<const YamlNode> rest = std::span(list.items).subspan(i);
    const std::size_t count = count_pieces(rest);
    if (count > 1) {
      const std::string text = joined(rest.first(count));
      found.error("E0308",
                  place_of(rest.first(count)),
                  fmt::format("'{}' is cut at its comma, which separates values of the list", text),
                  fmt::format("put it in quotes: \"{}\"", text));
      is_cut = true;
    }
    i += std::max<std::size_t>(count, 1);
  }
  return is_cut;
}

bool report_loose_end(const YamlNode& node, Diagnostics& found) {
  const bool has_end = is_piece(node) && !node.text.empty() &&
                       std::string_view("]},").find(node.text.back()) != std::string_view::npos &&
                       node.text.find_first_of("[{") == std::string::npos;
  if (!has_end) {
    return false;
  }
  const std::string rest = node.text.substr(0, node.text.size() - 1);
  const bool is_list = rest.find(',') != std::string::npos;
  found.error("E0204",
              place_in(node.where, node.text_column, node.text, static_cast<int>(rest.size()), 1),
              node.text.back() == ',' ? "',' ends a value that is in no list"
                                      : fmt::format("'{}' closes nothing", node.text.back()),
              is_list ? fmt::format("write [{}], or remove it", rest) : "remove it");
  return true;
}

std::string whole_entry(const YamlEntry& before, const YamlEntry& rest) {
  const bool is_cut = is_piece(before.value) && rest.value.kind == YamlKind::null &&
                      open_parentheses(before.value.text) > 0 && open_parentheses(rest.key) < 0;
  return is_cut ? fmt::format("{}: \"{}, {}\"", before.key, before.value.text, rest.key)
                : std::string();
}

std::string listed_entry(std::span<const YamlEntry> entries, std::size_t index) {
  const auto is_number = [](std::string_view text) {
    return !text.empty() && text.find_first_of("0123456789") <= 1 &&
           std::string_view("0123456789+-.").find(text.front()) != std::string_view::npos;
  };
  const auto is_component = [&](const YamlEntry& entry) {
    return entry.value.kind == YamlKind::null && is_number(entry.key);
  };
  std::size_t first = index;
  while (first > 0 && is_component(entries[first])) {
    --first;
  }
  if (first == index || !is_piece(entries[first].value) || !is_number(entries[first].value.text)) {
    return {};
  }
  std::string listed = entries[first].value.text;
  for (std::size_t i = first + 1; i < entries.size() && is_component(entries[i]); ++i) {
    listed += ", " + entries[i].key;
  }
  return fmt::format("{}: [{}]", entries[first].key, listed);
}

}  // namespace kinestat
