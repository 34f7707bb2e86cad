// What reports of other forms share with that of an analysis, as JSON.
#pragma once

#include <string>

#include "core/diagnostic.hpp"
#include "description/mechanism_description.hpp"
#include "report/json_archive.hpp"
#include "report/table_archive.hpp"

namespace kinestat {

/// The list behind "diagnostics".
Json diagnostics_json(const Diagnostics& found);

/// The name by which tables call the mechanism: its title or, without one, its file.
std::string name_in_tables(const std::string& file, const MechanismDescription& description);

/// The first line of a report: the mechanism's name, or its file, and its source.
std::string title_text(const std::string& file, const MechanismDescription& description);

/// JSON as the forms want it.
void add_json(const Json& json, const ReportForms& forms, FileReport& report);

/// JSON and tables, as far as the forms want them.
template <class View>
void add_forms(const Record<View>& record,
               const View& view,
               const ReportForms& forms,
               FileReport& report) {
  const FileUnits& units = view.description.units;
  if (forms.json || forms.json_line) {
    add_json(json_of(record, view, units), forms, report);
  }
  if (forms.csv) {
    report.csv = tables_of(record, view, name_in_tables(view.file, view.description), units);
  }
}

}  // namespace kinestat
