// The shift table of one file in the forms of a report.
#pragma once

#include "cases/analysis.hpp"
#include "core/diagnostic.hpp"
#include "report/report_forms.hpp"

namespace kinestat {

/// Head, key `shift` and diagnostics alone.
FileReport make_shift_report(const Analysis& analysis,
                             const ReportForms& forms,
                             const Diagnostics& found);

}  // namespace kinestat
