#include "report/file/shift_report.hpp"

#include "report/file/report_record.hpp"
#include "report/report_parts.hpp"
#include "studies/shift/report/shift_text.hpp"

namespace kinestat {

FileReport make_shift_report(const Analysis& analysis,
                             const ReportForms& forms,
                             const Diagnostics& found) {
  FileReport report;
  const ReportView view{.file = analysis.file,
                        .description = analysis.description,
                        .transmission = &analysis,
                        .found = &found};
  add_forms(report_record, view, forms, report);
  if (forms.text) {
    report.text =
        title_text(analysis.file, analysis.description) + "\n" + shift_blocks(analysis).text();
  }
  return report;
}

}  // namespace kinestat
