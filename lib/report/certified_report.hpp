// The report of an analysis with what is proved of it.
#pragma once

#include "report/certainty.hpp"
#include "report/file_report.hpp"

namespace kinestat {

/// make_report, with the certainty of the ranks in its evidence where anybody asked for it.
FileReport make_certified_report(const Analysis& analysis,
                                 const Certainty& certainty,
                                 const ReportForms& forms,
                                 Diagnostics& found);

}  // namespace kinestat
