#include "studies/compare/compare_json.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "core/version.hpp"
#include "studies/compare/compare_json_text.hpp"
#include "studies/compare/compare_place.hpp"
#include "studies/compare/compare_units.hpp"
#include "studies/compare/report_kinds.hpp"

namespace kinestat {

namespace {

std::string name_of(const Json& item) {
  if (item.is_string()) {
    return item.get<std::string>();
  }
  const auto at = item.find("name");
  return at != item.end() && at->is_string() ? at->get<std::string>() : "";
}

// The keys of the items of a list: their names, or their numbers if some have none or the same, or
// if their order means something.
std::vector<std::string> keys_of_items(const Json& list, bool is_ordered) {
  std::vector<std::string> keys;
  std::set<std::string> names;
  for (const Json& item : list) {
    keys.push_back(name_of(item));
    names.insert(keys.back());
  }
  if (names.contains("") || names.size() < keys.size() || is_ordered) {
    for (std::size_t i = 0; i < keys.size(); ++i) {
      keys[i] = std::to_string(i);
    }
  }
  return keys;
}

// A value on the way through a report, with what the record of reports says of it.
struct Visited {
  std::string place;
  const Json& value;
  const Shape* shape = nullptr;     // null of what this program does not know
  bool is_ordered = false;          // of a list of names
  const Json* object = nullptr;     // whose key it is
  const Json* reference = nullptr;  // the unit for one of which rates and actions are
  std::vector<std::string> labels;  // names of the elements on the way, and numbers of items

  Visited below(std::string_view key, const Json& item, const Shape* of_item) const {
    return {.place = place_below(place, key),
            .value = item,
            .shape = of_item,
            .is_ordered = false,
            .object = &value,
            .reference = reference,
            .labels = labels};
  }

  Visited element(const std::string& name, const Json& item, const Shape* of_item) const {
    Visited result = below(name, item, of_item);
    result.labels.push_back(name);
    return result;
  }
};

class Collector {
 public:
  Collector(const ReportUnits& units, ReportValues& values) : units_(units), values_(values) {}

  // Adds a value and all that it contains.
  void add(const Visited& at) {
    if (at.value.is_number()) {
      values_.append_number(at.place, at.value.get<double>(), unit_of(at));
    } else if (at.value.is_structured() && at.value.empty()) {
      values_.append({.place = at.place, .type = ValueType::empty, .text = {}});
    } else if (at.value.is_object()) {
      add_object(at);
    } else if (at.value.is_array()) {
      add_list(at);
    } else {
      add_word(at);
    }
  }

 private:
  ValueUnit unit_of(const Visited& at) const {
    if (at.shape != nullptr && at.object != nullptr &&
        at.shape->measure == Measure(ByContext::beside)) {
      return units_.beside(*at.object);
    }
    return at.shape != nullptr && at.reference != nullptr && is_magnitude(at.shape->measure)
               ? units_.per(*at.reference, *at.shape, at.labels)
               : units_.unit_of(at.shape, at.labels);
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
    for (const auto& [key, item] : at.value.items()) {
      if (!has_keys) {
        add(inside.element(key, item, item_shape(at.shape)));
        continue;
      }
      const Property* property = find_property(*at.shape->record, key);
      if (property == nullptr) {
        add(inside.below(key, item, nullptr));
      } else if (property->is_compared) {
        add_property(inside, *property, item);
      }
    }
  }

  void add_property(const Visited& at, const Property& property, const Json& item) {
    Visited next = at.below(property.key, item, &property.shape);
    next.is_ordered = property.is_ordered;
    if (property.shape.form == Shape::Form::list && is_of_cells(property.shape.items.front())) {
      add_rows(at.value, next);
    } else {
      add(next);
    }
  }

  void add_list(const Visited& at) {
    const std::vector<std::string> keys = keys_of_items(at.value, at.is_ordered);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const bool is_tuple = at.shape != nullptr && at.shape->form == Shape::Form::tuple;
      const Shape* item = !is_tuple                    ? item_shape(at.shape)
                          : i < at.shape->items.size() ? &at.shape->items[i]
                                                       : nullptr;
      add(at.element(keys[i], at.value[i], item));
    }
  }

  // A row has cells by the names of the columns of its motion.
  void add_rows(const Json& motion, const Visited& rows) {
    if (rows.value.empty()) {
      add(rows);
    }
    const std::vector<Column> columns = columns_of(motion, rows);
    for (std::size_t r = 0; r < rows.value.size(); ++r) {
      const Json& row = rows.value[r];
      if (columns.empty() || !row.is_array() || row.size() != columns.size()) {
        add(rows.element(std::to_string(r), row, item_shape(rows.shape)));
      } else {
        add_cells(rows.place + "/" + std::to_string(r), columns, rows, row);
      }
    }
  }

  // Of millions of cells the numbers differ alone: all else is found once a column.
  struct Column {
    std::string key;  // below the place of a row, with its "/"
    ValueUnit unit;
    bool is_compared = true;  // of two with one name, the first
  };

  std::vector<Column> columns_of(const Json& motion, const Visited& rows) const {
    std::vector<Column> columns;
    const auto named = motion.find("columns");
    if (named == motion.end() || !named->is_array()) {
      return columns;
    }
    const Shape* cell = item_shape(item_shape(rows.shape));
    std::set<std::string> names = {std::string(kClosureErrorColumn)};
    for (const Json& one : *named) {
      const std::string name = name_of(one);
      std::vector<std::string> labels = rows.labels;
      labels.insert(labels.end(), {std::string(), name});
      columns.push_back({.key = place_below("", name),
                         .unit = units_.unit_of(cell, labels),
                         .is_compared = names.insert(name).second});
    }
    return columns;
  }

  void add_cells(const std::string& place,
                 const std::vector<Column>& columns,
                 const Visited& rows,
                 const Json& row) {
    std::string at;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (!columns[c].is_compared) {
        continue;
      }
      at.assign(place).append(columns[c].key);
      if (row[c].is_number()) {
        values_.append_number(at, row[c].get<double>(), columns[c].unit);
      } else {
        add({.place = at,
             .value = row[c],
             .shape = item_shape(item_shape(rows.shape)),
             .is_ordered = false,
             .object = &row,
             .labels = rows.labels});
      }
    }
  }

  void add_word(const Visited& at) {
    const Json& value = at.value;
    values_.append({.place = at.place,
                    .type = value.is_null() ? ValueType::null : ValueType::text,
                    .text = value.is_string()    ? value.get<std::string>()
                            : value.is_boolean() ? (value.get<bool>() ? "true" : "false")
                                                 : ""});
  }

  // Of every element of a map or a list; a number by name is like the number alone.
  static const Shape* item_shape(const Shape* shape) {
    if (shape == nullptr || shape->items.empty()) {
      return shape != nullptr && shape->may_be_by_name ? shape : nullptr;
    }
    return &shape->items.front();
  }

  static bool is_of_cells(const Shape& row) {
    return !row.items.empty() && row.items.front().form == Shape::Form::cell;
  }

  static const Property* find_property(const RecordShape& record, std::string_view key) {
    const auto at = std::ranges::find(record.properties, key, &Property::key);
    return at != record.properties.end() && at->is_in_reports ? &*at : nullptr;
  }

  const ReportUnits& units_;
  ReportValues& values_;
};

// How often each code occurs.
void add_codes(const Json& report, ReportValues& values) {
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
    values.append_number(place_below("/diagnostics", code), count, count_unit());
  }
}

// Whether it is a report, and of the version that this program knows.
bool is_known_report(const Json& report, Diagnostics& found) {
  const auto head = report.find("kinestat");
  const Json version =
      head != report.end() && head->is_object() ? head->value("report", Json()) : Json();
  if (!version.is_number()) {
    found.error("E0903",
                {},
                "this is no report of kinestat: there is no /kinestat/report",
                "reports are written by 'kinestat analyze --format json' and by --out");
    return false;
  }
  if (version != kReportVersion) {
    found.error("E0904",
                {},
                fmt::format("the report is of version {} of its format, this program knows {}",
                            version.dump(),
                            kReportVersion),
                "write both reports with one version of kinestat");
    return false;
  }
  return true;
}

}  // namespace

std::optional<ReportValues> read_json_report(const SourceFile& source, Diagnostics& found) {
  const std::optional<Json> report = read_json(source, found);
  if (!report || !is_known_report(*report, found)) {
    return {};
  }
  std::string problem;
  const std::optional<ReportUnits> units = ReportUnits::read(*report, problem);
  if (!units) {
    found.error("E0903",
                {},
                problem,
                "the units that a report needs are listed by 'kinestat schema report'");
    return {};
  }
  ReportValues values(ReportForm::json);
  const Shape whole = object_shape(record_of(*report), false);
  Collector(*units, values).add({.place = "", .value = *report, .shape = &whole, .labels = {}});
  add_codes(*report, values);
  return values;
}

}  // namespace kinestat
