#include "studies/compare/compare_report.hpp"

#include <algorithm>
#include <string_view>

#include "core/utf8.hpp"
#include "studies/compare/compare_csv.hpp"
#include "studies/compare/compare_json.hpp"
#include "studies/compare/compare_rows.hpp"
#include "studies/compare/compare_sweep.hpp"

namespace kinestat {

std::optional<ReportValues> read_report(SourceFile& source, Diagnostics& found) {
  std::string_view text = source.text;
  if (text.starts_with(kByteOrderMark)) {
    text.remove_prefix(kByteOrderMark.size());
  }
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.starts_with("\x93NUMPY")) {
    found.error("E0903",
                {},
                "this is an array of NumPy, not a report",
                "sweep with --format csv or json to compare rows, and in NumPy with "
                "numpy.array_equal(a, b)");
    return {};
  }
  if (begins_with_rows(text)) {
    return read_sweep_rows(source, found);
  }
  if (text.starts_with('{')) {
    return has_reports_in_lines(text) ? read_json_reports(source, found)
                                      : read_json_report(source, found);
  }
  if (begins_with_keyed_rows(text)) {
    return read_keyed_rows(source, found);
  }
  const std::string_view first_line = text.substr(0, text.find('\n'));
  if (first_line.find(',') != std::string_view::npos) {
    return read_csv_report(source, found);
  }
  found.error(
      "E0903",
      {},
      text.empty() ? "this is not a report: the file is empty"
                   : "this is not a report: it begins neither as JSON nor as a table",
      "reports are written by 'kinestat analyze' with --out, --format json or --format csv");
  return {};
}

}  // namespace kinestat
