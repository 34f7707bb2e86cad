#include "pages/tables.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace kinestat {

namespace {

// Tables of more rows scroll within a box that can be folded; the style has their heights.
constexpr std::size_t kLong = 24;
constexpr std::size_t kLongBesidePicture = 14;

// Of so many columns the table itself says which have numbers; the style has a rule for each.
constexpr std::size_t kMostNumbered = 12;

// Cells of more characters may be broken into lines.
constexpr std::size_t kWide = 40;

bool is_sign(const std::string& cell) {
  return cell == "●" || cell == "·";
}

// What stands for a number that is not there, too.
bool is_number(const std::string& cell) {
  constexpr std::string_view kNone = "?-·.";
  if (cell.size() == 1 || cell == "·") {
    return kNone.find(cell) != std::string_view::npos || (cell[0] >= '0' && cell[0] <= '9');
  }
  const std::size_t first = cell.find_first_not_of("-*");
  return cell.empty() || cell.ends_with("infinite") ||
         (first != std::string::npos && cell[first] >= '0' && cell[first] <= '9' &&
          cell.find_first_not_of("0123456789.e+-*") == std::string::npos);
}

// The class of a column: numbers to the right, signs in the middle; words have none.
std::string class_of(const Table& table, std::size_t column) {
  const auto all = [&](auto&& is) {
    return std::ranges::all_of(table.rows(), [&](const auto& row) { return is(row[column]); });
  };
  if (column == 0) {
    return "";
  }
  if (all(is_sign)) {
    return "c";
  }
  if (all(is_number)) {
    return "n";
  }
  const bool is_wide = std::ranges::any_of(
      table.rows(), [&](const auto& row) { return row[column].size() > kWide; });
  return is_wide ? "w" : "";
}

// Where it is narrow, names of columns go on below behind the parts that they are made of.
void add_row_head(std::string_view head, Html& html) {
  std::string_view name = head.substr(0, head.find(" ["));
  const std::string_view unit = head.substr(name.size());
  html.open("th", {{"scope", "row"}});
  for (std::size_t end = name.find_first_of("/_"); end < name.size();
       end = name.find_first_of("/_")) {
    html.text(name.substr(0, end + 1));
    html.markup("<wbr>");
    name.remove_prefix(end + 1);
  }
  html.text(name);
  html.text(unit);
  html.close();
}

// "Fx [N]": the unit is set apart.
void add_head(const std::string& head, const std::string& kind, Html& html) {
  if (kind.empty()) {
    html.open("th", {{"scope", "col"}});
  } else {
    html.open("th", {{"scope", "col"}, {"class", kind}});
  }
  const std::size_t unit = head.find(" [");
  html.text(head.substr(0, unit));
  if (unit != std::string::npos) {
    html.text(" ");
    html.element("span", head.substr(unit + 1), {{"class", "unit"}});
  }
  html.close();
}

// "n1 n3": columns 1 and 3, from 0 on, have numbers; their cells then need no class.
std::string take_numbers(std::vector<std::string>& kinds) {
  std::string text;
  for (std::size_t c = 0; c < std::min(kinds.size(), kMostNumbered); ++c) {
    if (kinds[c] == "n") {
      text += fmt::format("{}n{}", text.empty() ? "" : " ", c);
      kinds[c].clear();
    }
  }
  return text;
}

void add_rows(const Table& table, const std::vector<std::string>& kinds, Html& html) {
  html.open("tbody");
  for (const auto& row : table.rows()) {
    html.markup("\n");
    html.open("tr");
    add_row_head(row.front(), html);
    for (std::size_t c = 1; c < row.size(); ++c) {
      if (kinds[c].empty()) {
        html.element("td", row[c]);
      } else {
        html.element("td", row[c], {{"class", kinds[c]}});
      }
    }
    html.close();
  }
  html.close();
}

void add_box(const Table& table, std::string_view name, Html& html) {
  std::vector<std::string> kinds;
  for (std::size_t c = 0; c < table.head().size(); ++c) {
    kinds.push_back(class_of(table, c));
  }
  html.open("div",
            {{"class", "box"},
             {"role", "group"},
             {"tabindex", "0"},
             {"aria-label", fmt::format("{}: {}", name, table.head().front())}});
  const std::string numbers = take_numbers(kinds);
  if (numbers.empty()) {
    html.open("table");
  } else {
    html.open("table", {{"class", numbers}});
  }
  html.open("thead");
  html.open("tr");
  for (std::size_t c = 0; c < kinds.size(); ++c) {
    add_head(table.head()[c], kinds[c], html);
  }
  html.close();
  html.close();
  add_rows(table, kinds, html);
  html.close();
  html.close();
}

// As a sentence begins, where a line begins with a word: names with digits or points, those of
// equations, and what ends with a colon, stay as they are written.
std::string sentence(std::string_view line) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz";
  std::string text(line);
  const std::size_t end = std::min(line.find_first_not_of(kLetters), line.size());
  const std::string_view rest = line.substr(end);
  if (end > 0 && (rest.starts_with(' ') || rest.starts_with(',') || rest.starts_with(';')) &&
      !rest.starts_with(" = ")) {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  }
  return text;
}

// A paragraph for each line that is not empty. A heading after an empty one begins something new.
void add_lines(std::string_view lines, Html& html) {
  if (lines.find_first_not_of(" \n") == std::string_view::npos) {
    return;
  }
  html.open("div", {{"class", "lines"}});
  bool is_after_empty = false;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    std::string_view line = lines.substr(0, end);
    lines.remove_prefix(std::min(end + 1, lines.size()));
    const std::size_t first = line.find_first_not_of(' ');
    if (first == 0 && is_after_empty) {
      html.element("p", sentence(line), {{"class", "heading"}});
    } else if (first != std::string_view::npos) {
      html.element("p", sentence(line.substr(first)));
    }
    is_after_empty = first == std::string_view::npos;
  }
  html.close();
}

}  // namespace

void add_table(const Table& table, std::string_view name, Html& html, TablePlace place) {
  if (table.rows().size() <= (place == TablePlace::page ? kLong : kLongBesidePicture)) {
    add_box(table, name, html);
    return;
  }
  html.open("details", {{"class", "long"}, {"open", ""}});
  html.element("summary", fmt::format("{}: {} rows", table.head().front(), table.rows().size()));
  add_box(table, name, html);
  html.close();
}

void add_blocks(const TextBlocks& blocks, std::string_view name, Html& html, TablePlace place) {
  html.open("div", {{"class", "blocks"}});
  for (const TextBlock& one : blocks.blocks()) {
    if (one.table) {
      add_table(*one.table, name, html, place);
    } else {
      add_lines(one.lines, html);
    }
  }
  html.close();
}

}  // namespace kinestat
