#include "report/file/motion_report.hpp"

#include "report/file/report_record.hpp"
#include "report/report_parts.hpp"
#include "studies/motion/report/motion_csv.hpp"
#include "studies/motion/report/motion_text.hpp"

namespace kinestat {

FileReport make_motion_report(const MotionAnalysis& analysis,
                              const ReportForms& forms,
                              const Diagnostics& found) {
  FileReport report;
  const ReportView view{.file = analysis.file,
                        .description = analysis.description,
                        .motion = &analysis.motion,
                        .found = &found};
  add_forms(report_record, view, forms, report);
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
