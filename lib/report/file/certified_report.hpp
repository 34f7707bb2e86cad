// The report of an analysis with what is proved of it.
#pragma once

#include "cases/certainty.hpp"
#include "report/file/file_report.hpp"
#include "studies/motion/report/motion_table.hpp"

namespace kinestat {

/// make_report, with the certainty of the ranks in its evidence where anybody asked for it, and
/// with the finite motion; `motion` is null where the file asks for none.
FileReport make_certified_report(const Analysis& analysis,
                                 const Certainty& certainty,
                                 const MotionTable* motion,
                                 const ReportForms& forms,
                                 Diagnostics& found);

}  // namespace kinestat
