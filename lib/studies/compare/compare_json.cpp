#include "studies/compare/compare_json.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "core/version.hpp"
#include "record/shapes.hpp"
#include "report/kinds/report_kinds.hpp"
#include "studies/compare/compare_json_text.hpp"
#include "studies/compare/compare_place.hpp"
#include "studies/compare/compare_units.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

namespace {

std::string_view name_of(const Json& item) {
  if (item.is_string()) {
    return item.get_ref<const std::string&>();
  }
  const auto at = item.find("name");
  return at != item.end() && at->is_string() ? at->get_ref<const std::string&>()
                                             : std::string_view();
}

// The names of the items of a list; empty if some have none or the same.
std::vector<std::string_view> names_of_items(const Json& list) {
  std::vector<std::string_view> names;
  std::set<std::string_view> seen;
  for (const Json& item : list) {
    const std::string_view name = name_of(item);
    if (name.empty() || !seen.insert(name).second) {
      return {};
    }
    names.push_back(name);
  }
  return names;
}

// A value on the way through a report, with what the record of reports says of it.
struct Visited {
  Json& value;
  const Shape* shape = nullptr;     // null of what this program does not know
  const Json* object = nullptr;     // whose key it is
  const Json* reference = nullptr;  // the unit for one of which rates and actions are
  bool is_ordered = false;          // of a list of names

  Visited below(Json& item, const Shape* of_item) const {
    // The unit of a vector stands beside it.
    const Json* const around = value.is_array() ? object : &value;
    return {.value = item, .shape = of_item, .object = around, .reference = reference};
  }
};

// Where a walk through a report has come to.
class ReportPath {
 public:
  explicit ReportPath(std::string place) : place_(std::move(place)) {}

  const std::string& place() const { return place_; }

  std::string_view last_key() const {
    return std::string_view(place_).substr(place_.rfind('/') + 1);
  }

  const Labels& labels() const { return labels_; }

  // Goes below a key for the time of a visit.
  template <typename Visit>
  void below(std::string_view key, Visit visit) {
    const std::size_t size = place_.size();
    append_key(place_, key);
    visit();
    place_.resize(size);
  }

  // Likewise below that of an element or an item.
  template <typename Visit>
  void element(std::string_view name, Visit visit) {
    labels_.push_back(name);
    below(name, visit);
    labels_.pop_back();
  }

 private:
  std::string place_;
  Labels labels_;
};

class Collector {
 public:
  // All of the report stands below a place.
  Collector(std::string place, const ReportUnits& units, ReportValues& values)
      : units_(units), values_(values), path_(std::move(place)) {}

  // Adds a value and all that it contains. What is read and large, an element of a map or a row of
  // a motion, is let go: a report would else be held twice.
  void add(const Visited& at) {
    if (at.value.is_number()) {
      values_.append_number(path_.place(), at.value.get<double>(), number_of(unit_of(at)));
    } else if (at.value.is_structured() && at.value.empty()) {
      values_.append(path_.place(), ValueType::empty);
    } else if (at.value.is_object()) {
      add_object(at);
    } else if (at.value.is_array()) {
      add_list(at);
    } else {
      add_word(at.value);
    }
  }

 private:
  const ValueUnit& unit_of(const Visited& at) const {
    if (at.shape != nullptr && at.object != nullptr &&
        at.shape->measure == Measure(ByContext::beside)) {
      return units_.beside(*at.object, path_.last_key());
    }
    return at.shape != nullptr && at.reference != nullptr && is_magnitude(at.shape->measure)
               ? units_.per(*at.reference, *at.shape, path_.labels())
               : units_.unit_of(at.shape, path_.labels());
  }

  // Among the units of the values.
  std::uint32_t number_of(const ValueUnit& unit) {
    const auto [at, is_new] = numbers_of_units_.try_emplace(&unit);
    if (is_new) {
      at->second = values_.index_of(unit);
    }
    return at->second;
  }

  static bool is_magnitude(const Measure& measure) {
    const auto* kind = std::get_if<QuantityKind>(&measure);
    return kind != nullptr
               ? kinestat::is_magnitude(*kind)
               : measure == Measure(ByContext::rate) || measure == Measure(ByContext::action);
  }

  // The text of the key that says so, if the record of the object has one.
  static const Json* reference_in(const Visited& at) {
    const auto& keys = at.shape->record->properties;
    const auto property = std::ranges::find_if(keys, &Property::is_reference_unit);
    const auto value = property == keys.end() ? at.value.end() : at.value.find(property->key);
    return value == at.value.end() ? at.reference : &*value;
  }

  void add_object(const Visited& at) {
    const bool has_keys = at.shape != nullptr && at.shape->record != nullptr;
    Visited inside = at;
    inside.reference = has_keys ? reference_in(at) : at.reference;
    for (auto& entry : at.value.get_ref<Json::object_t&>()) {
      const std::string& key = entry.first;
      Json& item = entry.second;  // by names, which clang 14 lets a function have
      if (!has_keys) {
        path_.element(key, [&] { add(inside.below(item, item_shape(at.shape))); });
        item = Json();
        continue;
      }
      const Property* property = find_property(*at.shape->record, key);
      if (property == nullptr || property->is_compared) {
        path_.below(key, [&] { add_property(inside, property, item); });
      }
    }
  }

  // Null of one that this program does not know.
  void add_property(const Visited& at, const Property* property, Json& item) {
    Visited next = at.below(item, property == nullptr ? nullptr : &property->shape);
    next.is_ordered = property != nullptr && property->is_ordered;
    if (item.is_array() && !item.empty() && is_of_rows(next.shape)) {
      add_rows(at.value, next);
    } else {
      add(next);
    }
  }

  void add_list(const Visited& at) {
    const bool is_tuple = at.shape != nullptr && at.shape->form == Shape::Form::tuple;
    const std::vector<std::string_view> names =
        at.is_ordered ? std::vector<std::string_view>() : names_of_items(at.value);
    for (std::size_t i = 0; i < at.value.size(); ++i) {
      const Shape* item = !is_tuple                    ? item_shape(at.shape)
                          : i < at.shape->items.size() ? &at.shape->items[i]
                                                       : nullptr;
      const std::string number = std::to_string(i);
      path_.element(names.empty() ? number : names[i], [&] { add(at.below(at.value[i], item)); });
    }
  }

  // A row has cells by the names of the columns of its motion.
  void add_rows(const Json& motion, const Visited& rows) {
    const std::vector<Column> columns = columns_of(motion, rows);
    for (std::size_t r = 0; r < rows.value.size(); ++r) {
      Json& row = rows.value[r];
      const std::string number = std::to_string(r);
      if (columns.empty() || !row.is_array() || row.size() != columns.size()) {
        path_.element(number, [&] { add(rows.below(row, item_shape(rows.shape))); });
      } else {
        path_.below(number, [&] { add_cells(columns, rows, row); });
      }
      row = Json();
    }
  }

  // Of millions of cells the numbers differ alone: all else is found once a column.
  struct Column {
    std::string_view name;
    std::uint32_t unit = 0;   // among those of the values
    bool is_compared = true;  // of two with one name, the first
  };

  std::vector<Column> columns_of(const Json& motion, const Visited& rows) {
    std::vector<Column> columns;
    const auto named = motion.find("columns");
    if (named == motion.end() || !named->is_array()) {
      return columns;
    }
    const Shape* cell = item_shape(item_shape(rows.shape));
    std::set<std::string_view> names = {kClosureErrorColumn};
    for (const Json& one : *named) {
      const std::string_view name = name_of(one);
      Labels labels = path_.labels();
      labels.insert(labels.end(), {std::string_view(), name});
      columns.push_back({.name = name,
                         .unit = number_of(units_.unit_of(cell, labels)),
                         .is_compared = names.insert(name).second});
    }
    return columns;
  }

  void add_cells(const std::vector<Column>& columns, const Visited& rows, Json& row) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (!columns[c].is_compared) {
        continue;
      }
      path_.below(columns[c].name, [&] {
        if (row[c].is_number()) {
          values_.append_number(path_.place(), row[c].get<double>(), columns[c].unit);
        } else {
          add({.value = row[c], .shape = item_shape(item_shape(rows.shape)), .object = &row});
        }
      });
    }
  }

  void add_word(const Json& value) {
    if (value.is_null()) {
      values_.append(path_.place(), ValueType::null);
    } else if (value.is_boolean()) {
      values_.append(path_.place(), ValueType::text, value.get<bool>() ? "true" : "false");
    } else {
      values_.append(path_.place(), ValueType::text, value.get_ref<const std::string&>());
    }
  }

  // Of every element of a map or a list; a number by name is like the number alone.
  static const Shape* item_shape(const Shape* shape) {
    if (shape == nullptr || shape->items.empty()) {
      return shape != nullptr && shape->may_be_by_name ? shape : nullptr;
    }
    return &shape->items.front();
  }

  static bool is_of_rows(const Shape* shape) {
    if (shape == nullptr || shape->form != Shape::Form::list) {
      return false;
    }
    const Shape& row = shape->items.front();
    return !row.items.empty() && row.items.front().form == Shape::Form::cell;
  }

  static const Property* find_property(const RecordShape& record, std::string_view key) {
    const auto at = std::ranges::find(record.properties, key, &Property::key);
    return at != record.properties.end() && at->is_in_reports ? &*at : nullptr;
  }

  const ReportUnits& units_;
  ReportValues& values_;
  ReportPath path_;
  std::unordered_map<const ValueUnit*, std::uint32_t> numbers_of_units_;
};

// How often each code occurs.
void add_codes(const Json& report, const std::string& place, ReportValues& values) {
  const auto list = report.find("diagnostics");
  std::map<std::string, int> counts;
  if (list != report.end() && list->is_array()) {
    for (const Json& one : *list) {
      const auto code = one.find("code");
      if (code != one.end() && code->is_string()) {
        ++counts[code->get<std::string>()];
      }
    }
  }
  for (const auto& [code, count] : counts) {
    values.append_number(
        place_below(place + "/diagnostics", code), count, values.index_of(count_unit()));
  }
}

// What this program writes as JSON beside reports, by a key of its head.
struct OtherOutput {
  std::string_view key;
  std::string_view what;
  std::string_view hint;
};

constexpr std::array<OtherOutput, 3> kOtherOutputs = {{
    {"comparison",
     "this is what a comparison has found, not a report",
     "compare the two reports themselves, perhaps with another --tolerance"},
    {"sweep",
     "this tells how a sweep was made, and is not its rows",
     "compare the rows beside it: <name>.sweep.csv or <name>.sweep.jsonl"},
    {"diagnostics", "these are messages, not a report", "compare them as text: diff A B"},
}};

void refuse_other(const Json& value, const Json& head, Diagnostics& found) {
  const auto* const other = std::ranges::find_if(
      kOtherOutputs, [&](const OtherOutput& one) { return head.contains(one.key); });
  if (head.is_object() && other != kOtherOutputs.end()) {
    found.error("E0903", {}, std::string(other->what), std::string(other->hint));
  } else if (value.contains("$schema")) {
    found.error("E0903",
                {},
                "this is a schema or a SARIF log, not a report",
                "compare them as text: diff A B");
  } else {
    found.error("E0903",
                {},
                "this is not a report of kinestat: there is no /kinestat/report",
                "reports are written by 'kinestat analyze --format json' and by --out");
  }
}

// Whether it is a report, and of the version that this program knows.
bool is_known_report(const Json& report, Diagnostics& found) {
  const auto head = report.find("kinestat");
  const Json version =
      head != report.end() && head->is_object() ? head->value("report", Json()) : Json();
  if (!version.is_number()) {
    refuse_other(report, head != report.end() ? *head : Json(), found);
    return false;
  }
  if (version != kReportVersion) {
    found.error("E0904",
                {},
                fmt::format("the report is of version {} of its format, this program reads {}",
                            version.dump(),
                            kReportVersion),
                "write both reports with one version of kinestat");
    return false;
  }
  return true;
}

// False if an error was added.
bool add_report(Json& report, const std::string& place, ReportValues& values, Diagnostics& found) {
  if (!is_known_report(report, found)) {
    return false;
  }
  std::string problem;
  const std::optional<ReportUnits> units = ReportUnits::read(report, problem);
  if (!units) {
    found.error("E0903",
                {},
                problem,
                "the units that a report needs are listed by 'kinestat schema report'");
    return false;
  }
  const Shape whole = object_shape(record_of(report), false);
  Collector(place, *units, values).add({.value = report, .shape = &whole});
  add_codes(report, place, values);
  return true;
}

// What the report is on.
std::string file_of(const Json& report) {
  const auto mechanism = report.find("mechanism");
  const Json file = mechanism != report.end() && mechanism->is_object()
                        ? mechanism->value("file", Json())
                        : Json();
  return file.is_string() ? file.get<std::string>() : std::string();
}

std::string_view first_line_of(std::string_view text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace

bool has_reports_in_lines(std::string_view text) {
  const std::string_view line = first_line_of(text);
  const std::string_view rest = text.substr(std::min(text.size(), line.size() + 1));
  return line.starts_with('{') && line.find('}') != std::string_view::npos &&
         first_line_of(rest).starts_with('{');
}

std::optional<ReportValues> read_json_report(SourceFile& source, Diagnostics& found) {
  std::optional<Json> report = read_json(source, found);
  if (!report) {
    return {};
  }
  source.text = std::string();  // what is wrong from here on has no place in it
  ReportValues values(ReportForm::json);
  return add_report(*report, "", values, found) ? std::optional(std::move(values)) : std::nullopt;
}

std::optional<ReportValues> read_json_reports(const SourceFile& source, Diagnostics& found) {
  ReportValues values(ReportForm::json);
  std::set<std::string> files;
  std::string_view rest = source.text;
  for (int line = 1; !rest.empty() && !found.has_errors(); ++line) {
    const std::string text(first_line_of(rest));
    rest.remove_prefix(std::min(rest.size(), text.size() + 1));
    if (text.find_first_not_of(" \t\r") == std::string::npos) {
      continue;
    }
    Diagnostics wrong;
    std::optional<Json> report = read_json({.path = source.path, .text = text}, wrong);
    const std::string file = report ? file_of(*report) : std::string();
    if (report && !files.insert(file).second) {
      wrong.error("E0903",
                  {},
                  fmt::format("there are two reports on '{}'", printable(file)),
                  "compare one run of a command at a time");
    } else if (report) {
      add_report(*report, place_below("", file), values, wrong);
    }
    for (Diagnostic one : wrong.items()) {
      one.where = {.line = line, .column = std::max(1, one.where.column), .length = 1};
      found.error(one.code, one.where, one.message, one.hint);
    }
  }
  return found.has_errors() ? std::nullopt : std::optional(std::move(values));
}

}  // namespace kinestat
