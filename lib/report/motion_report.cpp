#include "report/motion_report.hpp"

#include "core/utf8.hpp"
#include "report/analysis_json.hpp"
#include "report/analysis_text.hpp"
#include "report/mechanism_json.hpp"
#include "report/motion_csv.hpp"
#include "report/motion_json.hpp"
#include "report/motion_text.hpp"

namespace kinestat {

std::string name_in_tables(const std::string& file, const MechanismDescription& description) {
  return description.name.empty() ? printable(file) : description.name;
}

FileReport make_motion_report(const MotionAnalysis& analysis,
                              const ReportForms& forms,
                              const Diagnostics& found) {
  FileReport report;
  if (forms.json || forms.json_line) {
    Json json = report_head(analysis.file, analysis.description);
    json["motion"] = motion_json(analysis.motion);
    json["diagnostics"] = diagnostics_json(found);
    report.json = forms.json ? json.dump(2) + "\n" : std::string();
    report.json_line = forms.json_line ? json.dump() + "\n" : std::string();
  }
  if (forms.csv) {
    report.csv.push_back(
        {.pass = "motion",
         .text = motion_csv(name_in_tables(analysis.file, analysis.description), analysis.motion)});
  }
  if (forms.text) {
    report.text = title_text(analysis.file, analysis.description) + "\n" +
                  motion_blocks(analysis.motion).text();
  }
  return report;
}

}  // namespace kinestat
