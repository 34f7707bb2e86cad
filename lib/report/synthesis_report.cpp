#include "report/synthesis_report.hpp"

#include "report/analysis_json.hpp"
#include "report/mechanism_json.hpp"
#include "report/synthesis_csv.hpp"
#include "report/synthesis_json.hpp"
#include "report/synthesis_text.hpp"

namespace kinestat {

FileReport make_synthesis_report(const SynthesisAnalysis& analysis,
                                 const ReportForms& forms,
                                 const Diagnostics& found) {
  FileReport report;
  if (forms.json || forms.json_line || forms.csv) {
    Json json = report_head(analysis.file, analysis.description);
    json["synthesis"] = synthesis_json(analysis);
    json["diagnostics"] = diagnostics_json(found);
    report.json = forms.json ? json.dump(2) + "\n" : std::string();
    report.json_line = forms.json_line ? json.dump() + "\n" : std::string();
    if (forms.csv) {
      report.csv.push_back(
          {.pass = "synthesis", .text = synthesis_csv(analysis, json["synthesis"])});
    }
  }
  if (forms.text) {
    report.text = synthesis_text(analysis);
  }
  return report;
}

}  // namespace kinestat
