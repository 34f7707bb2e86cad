#include "studies/compare/compare_rows.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/csv_reader.hpp"
#include "core/utf8.hpp"
#include "studies/compare/compare_place.hpp"
#include "studies/compare/csv_cell.hpp"
#include "studies/compare/ignored_keys.hpp"

namespace kinestat {

namespace {

using Heads = std::span<const std::string_view>;

// What a row is of, and which of its cells are words; all others are numbers.
struct RowForm {
  Heads keys;
  Heads words;
};

constexpr std::string_view kFile = "file";
constexpr std::string_view kStep = "step";

bool contains(Heads names, std::string_view one) {
  return std::ranges::find(names, one) != names.end();
}

bool has_all(const std::vector<std::string>& heads, Heads names) {
  return std::ranges::all_of(
      names, [&](std::string_view one) { return std::ranges::find(heads, one) != heads.end(); });
}

bool is_blank(const CsvRow& row) {
  return row.cells.size() == 1 && row.cells.front().empty();
}

// Null of another table.
const RowForm* find_form(const std::vector<std::string>& heads) {
  static constexpr std::array<std::string_view, 2> kCase = {kMechanismColumn, "case"};
  static constexpr std::array<std::string_view, 1> kStatus = {"status"};
  static constexpr std::array<std::string_view, 3> kEntry = {"matrix", "row", "column"};
  static constexpr std::array<std::string_view, 1> kCoupling = {"coupling"};
  static constexpr std::array<std::string_view, 4> kEnds = {"type", "tail", "head", "part"};
  static const std::array<RowForm, 3> forms = {{{.keys = kCase, .words = kStatus},
                                                {.keys = kEntry, .words = {}},
                                                {.keys = kCoupling, .words = kEnds}}};
  const auto* const form = std::ranges::find_if(forms, [&](const RowForm& one) {
    return has_all(heads, one.keys) && has_all(heads, one.words);
  });
  const auto is_of_values = [](std::string_view head) {
    return head == "pass" || head == "quantity";
  };
  return form == forms.end() || std::ranges::any_of(heads, is_of_values) ? nullptr : form;
}

class RowReader {
 public:
  RowReader(const RowForm& form, Diagnostics& found) : form_(form), found_(found) {}

  // False if an error was added.
  bool set_heads(const CsvRow& heads) {
    for (const std::string& head : heads.cells) {
      std::optional<ColumnTitle> title = read_title(head, heads.line, found_);
      if (!title) {
        return false;
      }
      if (std::ranges::count(heads.cells, head) > 1) {
        refuse_line(heads.line,
                    fmt::format("the table has two columns '{}'", printable(head.substr(0, 80))),
                    "",
                    found_);
        return false;
      }
      titles_.push_back(*std::move(title));
    }
    set_keys();
    group_columns();
    return true;
  }

  void add(const CsvRow& row) {
    if (row.cells.size() != titles_.size()) {
      refuse_line(row.line,
                  fmt::format("the row has {} cells, not {}", row.cells.size(), titles_.size()),
                  "",
                  found_);
      return;
    }
    std::string place;
    for (const std::size_t key : keys_) {
      const std::string& cell = row.cells[key];
      const std::string& name = titles_[key].name;
      append_key(place,
                 name == kStep              ? fmt::format("{} {}", kStep, cell)
                 : name == kMechanismColumn ? compared_name(cell)
                                            : cell);
    }
    for (const std::vector<std::size_t>& columns : columns_) {
      if (!add_value(row, place, columns)) {
        return;
      }
    }
  }

  ReportValues take_values() { return std::move(values_); }

 private:
  // The file first. Gears have a number "step"; that of a motion stands behind the status.
  void set_keys() {
    const auto add_key = [&](std::string_view name) {
      const auto at = std::ranges::find(titles_, name, &ColumnTitle::name);
      if (at != titles_.end()) {
        keys_.push_back(static_cast<std::size_t>(at - titles_.begin()));
      }
    };
    add_key(kFile);
    std::ranges::for_each(form_.keys, add_key);
    const auto status = std::ranges::find(titles_, "status", &ColumnTitle::name);
    if (status != titles_.end() && status + 1 != titles_.end() && (status + 1)->name == kStep) {
      keys_.push_back(static_cast<std::size_t>(status + 1 - titles_.begin()));
    }
  }

  // An element may have the name of a key that is ignored.
  static bool is_compared(std::string_view title) {
    const std::size_t slash = title.find('/');
    return is_compared_in_tables(slash == std::string_view::npos ? title : title.substr(slash + 1));
  }

  // Files in other units have another column of the name: a row has its value in one of them.
  void group_columns() {
    std::map<std::string_view, std::size_t> groups;
    for (std::size_t i = 0; i < titles_.size(); ++i) {
      if (std::ranges::find(keys_, i) != keys_.end() || !is_shown(titles_[i].name)) {
        continue;
      }
      const auto [at, is_new] = groups.emplace(titles_[i].name, columns_.size());
      if (is_new) {
        columns_.emplace_back();
      }
      columns_[at->second].push_back(i);
    }
  }

  bool is_shown(std::string_view name) const {
    return contains(form_.words, name) || is_compared(name);
  }

  // False if an error was added.
  bool add_value(const CsvRow& row,
                 const std::string& above,
                 const std::vector<std::size_t>& columns) {
    const auto filled = [&](std::size_t one) { return !row.cells[one].empty(); };
    const auto at = std::ranges::find_if(columns, filled);
    const std::string& name = titles_[columns.front()].name;
    const std::string place = above + "/" + name;  // a path already
    bool is_new = std::ranges::count_if(columns, filled) <= 1;
    if (contains(form_.words, name)) {
      is_new = is_new && values_.add(place, ValueType::text, row.cells[columns.front()]);
    } else if (at == columns.end()) {
      is_new = is_new && values_.add(place, ValueType::null);
    } else {
      const std::optional<double> number = read_cell(row.cells[*at], row.line, found_);
      if (!number) {
        return false;
      }
      is_new = is_new && values_.add_number(place, *number, titles_[*at].unit);
    }
    if (!is_new) {
      refuse_line(row.line,
                  fmt::format("there are two rows for {}", printable(above)),
                  "compare one mechanism at a time, or give each another name",
                  found_);
    }
    return is_new;
  }

  const RowForm& form_;
  Diagnostics& found_;
  std::vector<ColumnTitle> titles_;
  std::vector<std::size_t> keys_;                  // columns
  std::vector<std::vector<std::size_t>> columns_;  // of each name that is no key
  ReportValues values_{ReportForm::csv};
};

}  // namespace

bool begins_with_keyed_rows(std::string_view text) {
  const auto heads = CsvReader(text).next();
  return heads && find_form(heads->cells) != nullptr;
}

std::optional<ReportValues> read_keyed_rows(const SourceFile& source, Diagnostics& found) {
  CsvReader reader(source.text);
  std::optional<CsvRow> heads = reader.next();
  while (heads && is_blank(*heads)) {
    heads = reader.next();
  }
  const RowForm* form = heads ? find_form(heads->cells) : nullptr;
  KINESTAT_EXPECTS(form != nullptr);
  RowReader rows(*form, found);
  if (!rows.set_heads(*heads)) {
    return {};
  }
  while (const auto row = reader.next()) {
    if (found.error_count() == kMostTableErrors) {
      return {};
    }
    if (!is_blank(*row)) {
      rows.add(*row);
    }
  }
  if (reader.is_broken()) {
    refuse_line(reader.line(), "a quote is not closed, or text follows one", "", found);
  }
  return found.has_errors() ? std::nullopt : std::optional(rows.take_values());
}

}  // namespace kinestat
