#include "core/csv_reader.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "core/utf8.hpp"

namespace kinestat {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  const std::size_t last = text.find_last_not_of(" \t");
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, last - first + 1);
}

std::string_view other_separators(const CsvRow& head) {
  const auto has = [&](char separator) {
    return std::ranges::any_of(head.cells, [separator](const std::string& cell) {
      return cell.find(separator) != std::string::npos;
    });
  };
  return has('\t') ? "tabs" : has(';') ? "semicolons" : "";
}

CsvReader::CsvReader(std::string_view text) : rest_(text) {
  if (rest_.starts_with(kByteOrderMark)) {
    rest_.remove_prefix(kByteOrderMark.size());
  }
}

std::optional<CsvRow> CsvReader::next() {
  if (rest_.empty()) {
    return {};
  }
  CsvRow row{.line = line_, .cells = {}};
  do {
    row.cells.push_back(cell());
  } while (!is_broken_ && take(','));
  is_broken_ = is_broken_ || !ends_line();
  ++line_;
  return is_broken_ ? std::nullopt : std::optional(std::move(row));
}

bool CsvReader::take(char c) {
  const bool is_next = rest_.starts_with(c);
  rest_.remove_prefix(is_next ? 1 : 0);
  return is_next;
}

bool CsvReader::ends_line() {
  take('\r');
  return rest_.empty() || take('\n');
}

std::string CsvReader::cell() {
  if (take('"')) {
    return quoted();
  }
  const std::size_t end = std::min(rest_.find_first_of(",\r\n"), rest_.size());
  std::string text(rest_.substr(0, end));
  rest_.remove_prefix(end);
  return text;
}

std::string CsvReader::quoted() {
  std::string text;
  while (true) {
    const std::size_t end = rest_.find('"');
    if (end == std::string_view::npos) {
      is_broken_ = true;
      return text;
    }
    text += rest_.substr(0, end);
    line_ += static_cast<int>(std::ranges::count(rest_.substr(0, end), '\n'));
    rest_.remove_prefix(end + 1);
    if (!take('"')) {
      return text;
    }
    text += '"';
  }
}

}  // namespace kinestat
