#include "report/table.hpp"

#include <algorithm>

#include "core/contract.hpp"
#include "core/utf8.hpp"
#include "report/styled_text.hpp"

namespace kinestat {

namespace {

// Columns from one to the one behind another, beside the first.
struct ColumnRange {
  std::size_t first = 1;
  std::size_t end = 1;
};

constexpr std::size_t kGap = 2;  // between columns

std::string line(const std::vector<std::string>& cells,
                 const std::vector<std::size_t>& widths,
                 const ColumnRange& range,
                 const std::string& indent) {
  const auto padding = [&](std::size_t i) {
    return std::string(widths[i] - columns_of(cells[i]), ' ');
  };
  std::string result = indent;
  if (!cells.empty()) {
    result += cells.front() + padding(0);
  }
  for (std::size_t i = range.first; i < range.end; ++i) {
    result += std::string(kGap, ' ') + padding(i) + cells[i];
  }
  result.erase(result.find_last_not_of(' ') + 1);
  return result + "\n";
}

// As many columns a part as fit, at least one; all where there is no width to keep to.
std::vector<ColumnRange> parts_of(const std::vector<std::size_t>& widths,
                                  std::size_t indent,
                                  std::size_t width) {
  std::vector<ColumnRange> parts(1);
  std::size_t used = 0;
  for (std::size_t i = 1; i < widths.size(); ++i) {
    const bool is_full = width > 0 && parts.back().end > parts.back().first &&
                         indent + widths.front() + used + kGap + widths[i] > width;
    if (is_full) {
      parts.push_back({.first = i, .end = i});
      used = 0;
    }
    used += kGap + widths[i];
    parts.back().end = i + 1;
  }
  return parts;
}

std::string heading(const std::string& head) {
  return styled(head.substr(0, head.size() - 1), LineStyle::heading) + "\n";
}

}  // namespace

Table::Table(std::vector<std::string> head) : head_(std::move(head)) {}

void Table::add(std::vector<std::string> row) {
  KINESTAT_EXPECTS(row.size() == head_.size());
  rows_.push_back(std::move(row));
}

std::string Table::text(const std::string& indent, const TextLayout& layout) const {
  std::vector<std::size_t> widths;
  for (const std::string& cell : head_) {
    widths.push_back(columns_of(cell));
  }
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], columns_of(row[i]));
    }
  }
  std::string result;
  for (const ColumnRange& part : parts_of(widths, columns_of(indent), layout.width)) {
    const std::string head = line(head_, widths, part, indent);
    result += result.empty() ? "" : "\n";
    result += layout.is_coloured && !head_.empty() ? heading(head) : head;
    for (const auto& row : rows_) {
      result += line(row, widths, part, indent);
    }
  }
  return result;
}

}  // namespace kinestat
