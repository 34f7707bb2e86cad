#include "studies/compare/compare_sweep.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "studies/compare/compare_json_text.hpp"
#include "studies/compare/compare_place.hpp"
#include "studies/compare/csv_cell.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kCase = "case";
constexpr std::string_view kStatus = "status";

struct SweepTitles {
  std::vector<ColumnTitle> all;
  std::size_t case_at = 0;  // what stands before it is varied
};

std::string_view first_line(std::string_view text) {
  return text.substr(0, text.find_first_of("\r\n"));
}

// A report has both columns too, and in any order.
bool names_rows(const std::vector<std::string>& titles) {
  const auto has = [&](std::string_view one) {
    return std::ranges::find(titles, one) != titles.end();
  };
  return has(kCase) && titles.back() == kStatus && !(has("mechanism") && has("quantity"));
}

class SweepReader {
 public:
  explicit SweepReader(Diagnostics& found) : found_(found) {}

  // False if an error was added.
  bool set_titles(const std::vector<std::string>& titles, int line) {
    if (titles == texts_) {
      return true;
    }
    if (!texts_.empty() || !names_rows(titles)) {
      refuse_line(line,
                  texts_.empty() ? "this is not a row of a sweep: 'case' or 'status' is missing"
                                 : "the row has other keys than those before it",
                  "rows are written by 'kinestat sweep'",
                  found_);
      return false;
    }
    texts_ = titles;
    const auto last = std::ranges::find(titles.rbegin(), titles.rend(), kCase);
    titles_.case_at = static_cast<std::size_t>(titles.rend() - last) - 1;
    return std::ranges::all_of(titles,
                               [&](const std::string& one) { return add_title(one, line); });
  }

  void add(const CsvRow& row) {
    if (row.cells.size() != titles_.all.size()) {
      refuse_line(row.line,
                  fmt::format("the row has {} cells, not {}", row.cells.size(), titles_.all.size()),
                  "",
                  found_);
      return;
    }
    const auto place = place_of(row);
    if (!place) {
      return;
    }
    for (std::size_t i = titles_.case_at + 1; i + 1 < row.cells.size(); ++i) {
      if (!add_value(row, place_below(*place, titles_.all[i].name), i)) {
        return;
      }
    }
    const bool is_new =
        values_.add(place_below(*place, kStatus), ValueType::text, row.cells.back());
    if (!is_new) {
      refuse_line(
          row.line,
          fmt::format("there are two rows for {}", printable(*place)),
          "compare one sweep at a time; of a sample that draws a state twice, take repeated "
          "lines out: awk '!seen[$0]++'",
          found_);
    }
  }

  ReportValues take_values() { return std::move(values_); }

 private:
  bool add_title(const std::string& text, int line) {
    std::optional<ColumnTitle> title = read_title(text, line, found_);
    if (title) {
      titles_.all.push_back(*std::move(title));
    }
    return title.has_value();
  }

  // Below the state the case; empty iff an error was added.
  std::optional<std::string> place_of(const CsvRow& row) const {
    std::string state;
    for (std::size_t i = 0; i < titles_.case_at; ++i) {
      const auto& [name, unit] = titles_.all[i];
      const auto number = read_cell(row.cells[i], row.line, found_);
      if (!number) {
        return {};
      }
      const std::string si = unit.text.empty() ? "" : si_unit_of(unit.dimension);
      state += fmt::format("{}{} = {:.12g}{}{}",
                           state.empty() ? "" : ", ",
                           name,
                           unit.scale.to_si(*number),
                           si.empty() ? "" : " ",
                           si);
    }
    return place_below(place_below("", state), row.cells[titles_.case_at]);
  }

  // False if an error was added. A place that is taken shows when the status is added.
  bool add_value(const CsvRow& row, const std::string& place, std::size_t column) {
    if (row.cells[column].empty()) {
      values_.add(place, ValueType::null);
      return true;
    }
    const auto number = read_cell(row.cells[column], row.line, found_);
    if (number) {
      values_.add_number(place, *number, titles_.all[column].unit);
    }
    return number.has_value();
  }

  Diagnostics& found_;
  std::vector<std::string> texts_;
  SweepTitles titles_;
  ReportValues values_{ReportForm::csv};
};

void read_table(const SourceFile& source, SweepReader& rows, Diagnostics& found) {
  CsvReader reader(source.text);
  const auto titles = reader.next();
  if (!titles || !rows.set_titles(titles->cells, titles->line)) {
    return;
  }
  while (const auto row = reader.next()) {
    if (found.error_count() == kMostTableErrors) {
      return;
    }
    if (row->cells.size() != 1 || !row->cells.front().empty()) {
      rows.add(*row);
    }
  }
  if (reader.is_broken()) {
    refuse_line(reader.line(), "a quote is not closed, or text follows one", "", found);
  }
}

// The keys of a row are its titles.
void read_objects(const SourceFile& source, SweepReader& rows, Diagnostics& found) {
  std::string_view rest = source.text;
  for (int line = 1; !rest.empty() && !found.has_errors(); ++line) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view text = first_line(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (text.empty()) {
      continue;
    }
    Diagnostics wrong;
    const std::optional<Json> object =
        read_json({.path = source.path, .text = std::string(text)}, wrong);
    if (!object || !object->is_object()) {
      refuse_line(
          line, "the line is not a JSON object", "rows are written by 'kinestat sweep'", found);
      return;
    }
    std::vector<std::string> titles;
    CsvRow row{.line = line, .cells = {}};
    for (const auto& [key, value] : object->items()) {
      titles.push_back(key);
      row.cells.push_back(value.is_string() ? value.get<std::string>()
                          : value.is_null() ? ""
                                            : value.dump());
    }
    if (rows.set_titles(titles, line)) {
      rows.add(row);
    }
  }
}

}  // namespace

bool begins_with_rows(std::string_view text) {
  const std::string_view line = first_line(text);
  if (line.starts_with('{')) {
    return line.ends_with('}') && line.find("\"status\":") != std::string_view::npos &&
           line.find("\"kinestat\"") == std::string_view::npos;
  }
  const auto titles = CsvReader(line).next();
  return titles && names_rows(titles->cells);
}

std::optional<ReportValues> read_sweep_rows(const SourceFile& source, Diagnostics& found) {
  SweepReader rows(found);
  std::string_view text = source.text;
  if (text.starts_with(kByteOrderMark)) {
    text.remove_prefix(kByteOrderMark.size());
  }
  text.starts_with('{') ? read_objects(source, rows, found) : read_table(source, rows, found);
  return found.has_errors() ? std::nullopt : std::optional(rows.take_values());
}

}  // namespace kinestat
