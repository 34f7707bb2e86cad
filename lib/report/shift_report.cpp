#include "report/shift_report.hpp"

#include "report/analysis_json.hpp"
#include "report/analysis_text.hpp"
#include "report/mechanism_json.hpp"
#include "report/shift_csv.hpp"
#include "report/shift_json.hpp"
#include "report/shift_text.hpp"

namespace kinestat {

FileReport make_shift_report(const Analysis& analysis,
                             const ReportForms& forms,
                             const Diagnostics& found) {
  FileReport report;
  if (forms.json || forms.json_line || forms.csv) {
    Json json = report_head(analysis.file, analysis.description);
    json["shift"] = shift_json(analysis);
    json["diagnostics"] = diagnostics_json(found);
    report.json = forms.json ? json.dump(2) + "\n" : std::string();
    report.json_line = forms.json_line ? json.dump() + "\n" : std::string();
    if (forms.csv) {
      report.csv.push_back({.pass = "shift", .text = shift_csv(analysis, json["shift"])});
    }
  }
  if (forms.text) {
    report.text =
        title_text(analysis.file, analysis.description) + "\n" + shift_blocks(analysis).text();
  }
  return report;
}

}  // namespace kinestat
