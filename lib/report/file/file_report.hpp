// The report of one file in the forms asked for.
#pragma once

#include <string>

#include "cases/analysis.hpp"
#include "core/diagnostic.hpp"
#include "report/report_forms.hpp"

namespace kinestat {

/// Checks the published values, whose errors are added to `found`, then writes the forms; the JSON
/// carries all of `found`.
FileReport make_report(const Analysis& analysis, const ReportForms& forms, Diagnostics& found);

/// The report of a file that is right but has nothing that was analysed: what every report begins
/// with, and the diagnostics.
FileReport make_head_report(const std::string& file,
                            const MechanismDescription& description,
                            const ReportForms& forms,
                            const Diagnostics& found);

}  // namespace kinestat
