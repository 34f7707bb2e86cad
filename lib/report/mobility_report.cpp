#include "report/mobility_report.hpp"

#include "report/report_parts.hpp"
#include "report/mobility_csv.hpp"
#include "report/mobility_json.hpp"
#include "report/mobility_text.hpp"

namespace kinestat {

FileReport make_mobility_report(const MobilityAnalysis& analysis,
                                const ReportForms& forms,
                                const Diagnostics& found) {
  FileReport report;
  if (forms.json || forms.json_line || forms.csv) {
    Json json = report_head(analysis.file, analysis.description);
    json["mobility"] = mobility_json(analysis);
    json["diagnostics"] = diagnostics_json(found);
    report.json = forms.json ? json.dump(2) + "\n" : std::string();
    report.json_line = forms.json_line ? json.dump() + "\n" : std::string();
    if (forms.csv) {
      report.csv.push_back({.pass = "mobility", .text = mobility_csv(analysis, json["mobility"])});
    }
  }
  if (forms.text) {
    report.text = mobility_text(analysis);
  }
  return report;
}

}  // namespace kinestat
