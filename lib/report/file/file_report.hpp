// The report of one file in the forms asked for.
#pragma once

#include <string>

#include "cases/analysis.hpp"
#include "cases/certainty.hpp"
#include "core/diagnostic.hpp"
#include "report/report_forms.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// Checks the published values, whose errors are added to `found`, then writes the forms; the JSON
/// carries all of `found`, the certainty of the ranks where anybody asked for it, and the finite
/// motion; `motion` is null where the file asks for none.
FileReport make_report(const Analysis& analysis,
                       const Certainty& certainty,
                       const MotionTable* motion,
                       const ReportForms& forms,
                       Diagnostics& found);

/// The report of a file that is right but has nothing that was analysed: what every report begins
/// with, and the diagnostics.
FileReport make_head_report(const std::string& file,
                            const MechanismDescription& description,
                            const ReportForms& forms,
                            const Diagnostics& found);

/// What the report of a motion is made of.
struct MotionAnalysis {
  std::string file;  ///< as the user gave it
  MechanismDescription description;
  MotionTable motion;
};

/// A finite motion: head, key `motion` and diagnostics alone.
FileReport make_motion_report(const MotionAnalysis& analysis,
                              const ReportForms& forms,
                              const Diagnostics& found);

/// A shift table: head, key `shift` and diagnostics alone.
FileReport make_shift_report(const Analysis& analysis,
                             const ReportForms& forms,
                             const Diagnostics& found);

/// The report as tables for people: title, what people ask first of all cases and gears, the
/// extremes of a motion if there is one, for every case the known and the solved magnitudes, six
/// significant digits, with units, and counts. Columns that are zero throughout are left out.
TextBlocks analysis_text(const Analysis& analysis, const MotionTable* motion);

}  // namespace kinestat
