// The finite motion of one file in the forms of a report.
#pragma once

#include <string>

#include "cases/analysis.hpp"
#include "core/diagnostic.hpp"
#include "report/report_forms.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// What the report of a motion is made of.
struct MotionAnalysis {
  std::string file;  ///< as the user gave it
  MechanismDescription description;
  MotionTable motion;
};

/// Head, key `motion` and diagnostics alone.
FileReport make_motion_report(const MotionAnalysis& analysis,
                              const ReportForms& forms,
                              const Diagnostics& found);

}  // namespace kinestat
