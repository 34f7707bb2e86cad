#include "report/compare_json.hpp"

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
#include "report/compare_json_text.hpp"
#include "report/compare_place.hpp"
#include "report/compare_units.hpp"

namespace kinestat {

namespace {

// What may differ between two runs that mean the same, and the units, by which values are read.
constexpr auto kLeftOut = std::to_array<std::string_view>({
    "/kinestat",
    "/mechanism/file",
    "/mechanism/units",
    "/mechanism/parameters/*/expression",
    "/mechanism/parameters/*/unit",
    "/mobility/evidence",
    "/cases/*/evidence",
    "/cases/*/*/evidence",
    "/cases/*/power/balance_residual",
    "/cases/*/power/losses/balance_residual",
    "/cases/*/power/efficiency/reason",
    "/cases/*/power/efficiency/reasons",
    "/cases/*/reason",
    "/graph/matrices/*/meaning",
    "/motion/drives/*/unit",
    "/motion/columns/*/unit",
    "/motion/closure",
    "/motion/rows/*/misclosure",
    "/motion/events/*/uncertainty",
    "/diagnostics",
});

// Lists of names whose order means something.
constexpr auto kOrdered = std::to_array<std::string_view>({
    "/graph/couplings/*/bodies",
    "/graph/matrices/*/rows",
    "/graph/matrices/*/columns",
});

template <class Patterns>
bool is_within_one(std::string_view place, const Patterns& patterns) {
  return std::ranges::any_of(
      patterns, [place](std::string_view pattern) { return is_within(place, pattern); });
}

std::string name_of(const Json& item) {
  if (item.is_string()) {
    return item.get<std::string>();
  }
  const auto at = item.find("name");
  return at != item.end() && at->is_string() ? at->get<std::string>() : "";
}

// The keys of the cells of a row of a motion: the names of their columns, or nothing if these do
// not fit.
std::vector<std::string> keys_of_cells(const Json& motion, const Json& row) {
  std::vector<std::string> keys;
  const auto columns = motion.find("columns");
  if (columns != motion.end() && columns->is_array() && row.is_array() &&
      columns->size() == row.size()) {
    std::ranges::transform(*columns, std::back_inserter(keys), name_of);
  }
  return keys;
}

// The keys of the items of a list: their names, or their numbers if some have none or the same.
std::vector<std::string> keys_of_items(const std::string& place, const Json& list) {
  std::vector<std::string> keys;
  std::set<std::string> names;
  for (const Json& item : list) {
    keys.push_back(name_of(item));
    names.insert(keys.back());
  }
  if (names.contains("") || names.size() < keys.size() || is_within_one(place, kOrdered)) {
    for (std::size_t i = 0; i < keys.size(); ++i) {
      keys[i] = std::to_string(i);
    }
  }
  return keys;
}

class Collector {
 public:
  Collector(const ReportUnits& units, ReportValues& values) : units_(units), values_(values) {}

  // Adds a value and all that it contains.
  void add(const std::string& place, const Json& value) {
    if (is_within_one(place, kLeftOut)) {
      return;
    }
    if (value.is_number()) {
      values_.add_number(place, value.get<double>(), units_.at(place));
    } else if (value.is_structured() && value.empty()) {
      values_.add({.place = place, .type = ValueType::empty, .text = {}});
    } else if (value.is_object()) {
      for (const auto& [key, item] : value.items()) {
        if (place == "/motion" && key == "rows" && item.is_array() && !item.empty()) {
          add_rows(value, item);
        } else {
          add(place_below(place, key), item);
        }
      }
    } else if (value.is_array()) {
      const std::vector<std::string> keys = keys_of_items(place, value);
      for (std::size_t i = 0; i < keys.size(); ++i) {
        add(place_below(place, keys[i]), value[i]);
      }
    } else {
      add_word(place, value);
    }
  }

 private:
  void add_rows(const Json& motion, const Json& rows) {
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const std::string place = place_below("/motion/rows", std::to_string(r));
      const std::vector<std::string> keys = keys_of_cells(motion, rows[r]);
      for (std::size_t c = 0; c < keys.size(); ++c) {
        add(place_below(place, keys[c]), rows[r][c]);
      }
      if (keys.empty()) {
        add(place, rows[r]);
      }
    }
  }

  void add_word(const std::string& place, const Json& value) {
    values_.add({.place = place,
                 .type = value.is_null() ? ValueType::null : ValueType::text,
                 .text = value.is_string()    ? value.get<std::string>()
                         : value.is_boolean() ? (value.get<bool>() ? "true" : "false")
                                              : ""});
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
    values.add_number(place_below("/diagnostics", code), count, count_unit());
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
  Collector(*units, values).add("", *report);
  add_codes(*report, values);
  return values;
}

}  // namespace kinestat
