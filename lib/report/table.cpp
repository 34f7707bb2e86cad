#include "report/table.hpp"

#include <algorithm>

#include "core/contract.hpp"
#include "core/utf8.hpp"

namespace kinestat {

namespace {

std::string line(const std::vector<std::string>& cells,
                 const std::vector<std::size_t>& widths,
                 const std::string& indent) {
  std::string result = indent;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string padding(widths[i] - columns_of(cells[i]), ' ');
    result += i == 0 ? cells[i] + padding : "  " + padding + cells[i];
  }
  result.erase(result.find_last_not_of(' ') + 1);
  return result + "\n";
}

}  // namespace

Table::Table(std::vector<std::string> head) : head_(std::move(head)) {}

void Table::add(std::vector<std::string> row) {
  KINESTAT_EXPECTS(row.size() == head_.size());
  rows_.push_back(std::move(row));
}

std::string Table::text(const std::string& indent) const {
  std::vector<std::size_t> widths;
  for (const std::string& cell : head_) {
    widths.push_back(columns_of(cell));
  }
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], columns_of(row[i]));
    }
  }
  std::string result = line(head_, widths, indent);
  for (const auto& row : rows_) {
    result += line(row, widths, indent);
  }
  return result;
}

}  // namespace kinestat
