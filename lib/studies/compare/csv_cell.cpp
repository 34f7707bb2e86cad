#include "studies/compare/csv_cell.hpp"

#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/utf8.hpp"

namespace kinestat {

void refuse_line(int line, std::string message, std::string hint, Diagnostics& found) {
  found.error("E0903",
              line == 0 ? SourceRange{} : SourceRange{.line = line, .column = 1, .length = 1},
              std::move(message),
              std::move(hint));
}

std::optional<double> read_cell(std::string_view text, int line, Diagnostics& found) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && std::isfinite(value)) {
    return value;
  }
  refuse_line(line,
              fmt::format("'{}' is not a number", printable(text.substr(0, 80))),
              "numbers have a decimal point, and the cell is empty where there is no value",
              found);
  return {};
}

}  // namespace kinestat
