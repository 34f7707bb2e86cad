// What the reports of all commands share.
#pragma once

#include <string>
#include <string_view>

#include "description/mechanism_description.hpp"
#include "report/json_archive.hpp"
#include "report/table_archive.hpp"

namespace kinestat {

/// The name by which tables call the mechanism: its title or, without one, its file.
std::string name_in_tables(const std::string& file, const MechanismDescription& description);

/// The first line of a report: the mechanism's name, or its file, and its source.
std::string title_text(const std::string& file, const MechanismDescription& description);

/// ", in the drawn position" behind the name of a case whose file moves the mechanism elsewhere
/// too, so that nobody takes its values for the extremes; else empty.
std::string_view in_drawn_position(const MechanismDescription& description);

/// JSON, as far as the forms want it. Records are large: `record` is called only where one is used.
template <class View>
void add_json(const Record<View>& (*record)(),
              const View& view,
              const FileUnits& units,
              const ReportForms& forms,
              FileReport& report) {
  if (forms.json) {
    report.json = json_text(record(), view, units, JsonLayout::indented);
  }
  if (forms.json_line) {
    report.json_line = json_text(record(), view, units, JsonLayout::line);
  }
}

/// JSON and tables, likewise.
template <class View>
void add_forms(const Record<View>& (*record)(),
               const View& view,
               const ReportForms& forms,
               FileReport& report) {
  const FileUnits& units = view.description.units;
  add_json(record, view, units, forms, report);
  if (forms.csv) {
    report.csv = tables_of(record(), view, name_in_tables(view.file, view.description), units);
  }
}

}  // namespace kinestat
