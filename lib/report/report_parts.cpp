#include "report/report_parts.hpp"

#include <fmt/format.h>

#include "core/utf8.hpp"
#include "report/diagnostic_record.hpp"

namespace kinestat {

Json diagnostics_json(const Diagnostics& found) {
  const FileUnits units;  // there are no quantities
  JsonArchive archive(units);
  write_diagnostics(found, archive);
  return archive.take();
}

std::string name_in_tables(const std::string& file, const MechanismDescription& description) {
  return description.name.empty() ? printable(file) : description.name;
}

std::string title_text(const std::string& file, const MechanismDescription& description) {
  const std::string name = printable(description.name.empty() ? file : description.name);
  return description.source.empty() ? name + "\n"
                                    : fmt::format("{} ({})\n", name, printable(description.source));
}

void add_json(const Json& json, const ReportForms& forms, FileReport& report) {
  if (forms.json) {
    report.json = json.dump(2) + "\n";
  }
  if (forms.json_line) {
    report.json_line = json.dump() + "\n";
  }
}

}  // namespace kinestat
