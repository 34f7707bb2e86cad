#include "studies/mobility/report/mobility_report.hpp"

#include "report/report_parts.hpp"
#include "studies/mobility/report/mobility_record.hpp"
#include "studies/mobility/report/mobility_text.hpp"

namespace kinestat {

FileReport make_mobility_report(const MobilityAnalysis& analysis,
                                const ReportForms& forms,
                                const Diagnostics& found) {
  FileReport report;
  const MobilityReportView view{.file = analysis.file,
                                .description = analysis.description,
                                .analysis = analysis,
                                .found = &found};
  add_forms(mobility_report_record, view, forms, report);
  if (forms.text) {
    report.text = mobility_text(analysis);
  }
  return report;
}

}  // namespace kinestat
