#include "report/file_report.hpp"

#include "report/analysis_csv.hpp"
#include "report/analysis_json.hpp"
#include "report/analysis_text.hpp"
#include "report/certainty_json.hpp"
#include "report/certified_report.hpp"
#include "report/mechanism_json.hpp"
#include "report/motion_csv.hpp"
#include "report/motion_json.hpp"
#include "report/motion_report.hpp"
#include "report/motion_text.hpp"
#include "report/published.hpp"

namespace kinestat {

std::string_view json_signature() {
  return "{\n  \"kinestat\": {";
}

std::string_view csv_signature() {
  // Tables may have more columns.
  return kCsvHeader.substr(0, kCsvHeader.size() - 1);
}

FileReport make_report(const Analysis& analysis, const ReportForms& forms, Diagnostics& found) {
  return make_certified_report(analysis, {}, nullptr, forms, found);
}

FileReport make_certified_report(const Analysis& analysis,
                                 const Certainty& certainty,
                                 const MotionTable* motion,
                                 const ReportForms& forms,
                                 Diagnostics& found) {
  FileReport report;
  const bool needs_json =
      forms.json || forms.json_line || forms.csv || !analysis.description.published.empty();
  if (needs_json) {
    Json json = analysis_json(analysis);
    if (certainty.motion_rank) {
      json["mobility"]["evidence"]["certainty"] = certainty_json(certainty);
    }
    if (motion != nullptr) {
      json["motion"] = motion_json(*motion);
    }
    check_published(json, analysis.description.published, found);
    json["diagnostics"] = diagnostics_json(found);
    if (forms.json) {
      report.json = json.dump(2) + "\n";
    }
    if (forms.json_line) {
      report.json_line = json.dump() + "\n";
    }
    if (forms.csv) {
      for (CsvTable& table : analysis_csv(analysis, json)) {
        report.csv.push_back({.pass = std::move(table.pass), .text = std::move(table.text)});
      }
      if (motion != nullptr) {
        const std::string name = name_in_tables(analysis.file, analysis.description);
        report.csv.push_back({.pass = "motion", .text = motion_csv(name, *motion)});
      }
    }
  }
  if (forms.text) {
    report.text = analysis_text(analysis);
    report.text += motion == nullptr ? "" : motion_summary(*motion).text();
  }
  return report;
}

FileReport make_head_report(const std::string& file,
                            const MechanismDescription& description,
                            const ReportForms& forms,
                            const Diagnostics& found) {
  FileReport report;
  Json json = report_head(file, description);
  json["diagnostics"] = diagnostics_json(found);
  if (forms.json) {
    report.json = json.dump(2) + "\n";
  }
  if (forms.json_line) {
    report.json_line = json.dump() + "\n";
  }
  if (forms.text) {
    report.text = title_text(file, description);
  }
  return report;
}

}  // namespace kinestat
