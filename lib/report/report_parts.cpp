#include "report/report_parts.hpp"

#include "core/utf8.hpp"
#include "report/report_record.hpp"

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

void add_json(const Json& json, const ReportForms& forms, FileReport& report) {
  if (forms.json) {
    report.json = json.dump(2) + "\n";
  }
  if (forms.json_line) {
    report.json_line = json.dump() + "\n";
  }
}

}  // namespace kinestat
