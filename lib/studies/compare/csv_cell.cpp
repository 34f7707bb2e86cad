#include "studies/compare/csv_cell.hpp"

#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>
#include <variant>

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

std::string compared_name(const std::string& mechanism) {
  return mechanism.ends_with(".yaml") || mechanism.ends_with(".yml") ? "" : mechanism;
}

std::optional<ColumnTitle> read_title(const std::string& text, int line, Diagnostics& found) {
  const std::size_t bracket = text.ends_with(']') ? text.rfind(" [") : std::string::npos;
  const std::string unit =
      bracket == std::string::npos ? "" : text.substr(bracket + 2, text.size() - bracket - 3);
  auto read = read_unit(unit);
  if (const auto* error = std::get_if<ExpressionError>(&read)) {
    refuse_line(
        line,
        fmt::format("column '{}': {}", printable(text.substr(0, 80)), printable(error->message)),
        error->hint,
        found);
    return {};
  }
  return ColumnTitle{.name = text.substr(0, bracket), .unit = std::get<ValueUnit>(std::move(read))};
}

}  // namespace kinestat
