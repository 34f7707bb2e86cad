#include "report/file/file_report.hpp"

#include "report/file/report_record.hpp"
#include "report/partial_archive.hpp"
#include "report/published.hpp"
#include "report/report_parts.hpp"
#include "report/table_archive.hpp"
#include "studies/motion/report/motion_csv.hpp"
#include "studies/motion/report/motion_text.hpp"
#include "studies/shift/report/shift_text.hpp"

namespace kinestat {

FileReport make_report(const Analysis& analysis,
                       const Certainty& certainty,
                       const MotionTable* motion,
                       const ReportForms& forms,
                       Diagnostics& found) {
  const FileUnits& units = analysis.description.units;
  ReportView view{.file = analysis.file,
                  .description = analysis.description,
                  .mechanism = &analysis.mechanism,
                  .analysis = &analysis,
                  .certainty = &certainty,
                  .transmission = analysis.shift ? &analysis : nullptr,
                  .motion = motion};
  if (const auto& published = analysis.description.published; !published.empty()) {
    const WantedKeys wanted = keys_of(published);
    PartialArchive partial(units, wanted);
    report_record().write(view, partial);
    check_published(Json::parse(partial.take()), analysis.description, found);
  }
  view.found = &found;
  FileReport report;
  add_json(report_record, view, units, forms, report);
  if (forms.csv) {
    const std::string name = name_in_tables(analysis.file, analysis.description);
    report.csv = tables_of(report_record(), view, name, units);
    if (motion != nullptr) {
      report.csv.push_back({.pass = "motion", .text = motion_csv(name, *motion)});
    }
  }
  if (forms.text) {
    report.text = analysis_text(analysis, motion);
  }
  return report;
}

FileReport make_head_report(const std::string& file,
                            const MechanismDescription& description,
                            const ReportForms& forms,
                            const Diagnostics& found) {
  FileReport report;
  const ReportView view{.file = file, .description = description, .found = &found};
  add_json(report_record, view, description.units, forms, report);
  if (forms.text) {
    report.text += title_text(file, description);
  }
  return report;
}

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
    report.text += title_text(analysis.file, analysis.description) + "\n";
    report.text += motion_blocks(analysis.motion);
  }
  return report;
}

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
    report.text += title_text(analysis.file, analysis.description) + "\n";
    report.text += shift_blocks(analysis);
  }
  return report;
}

}  // namespace kinestat
