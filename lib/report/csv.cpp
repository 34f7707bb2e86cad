#include "report/csv.hpp"

#include <algorithm>

namespace kinestat {

namespace {

// Letters, digits and signs, which most cells consist of, stand behind the comma.
bool needs_quotes(std::string_view cell) {
  return std::ranges::any_of(
      cell, [](char c) { return c <= ',' && (c == ',' || c == '"' || c == '\r' || c == '\n'); });
}

template <class Cell>
void append_cells(std::span<const Cell> cells, std::string& text) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) {
      text += ',';
    }
    append_csv_cell(cells[i], text);
  }
  text += '\n';
}

}  // namespace

void append_csv_cell(std::string_view cell, std::string& text) {
  if (!needs_quotes(cell)) {
    text += cell;
    return;
  }
  text += '"';
  for (const char c : cell) {
    text.append(c == '"' ? 2 : 1, c);
  }
  text += '"';
}

void append_csv_line(std::span<const std::string_view> cells, std::string& text) {
  append_cells(cells, text);
}

std::string csv_line(std::span<const std::string> cells) {
  std::string line;
  append_cells(cells, line);
  return line;
}

}  // namespace kinestat
