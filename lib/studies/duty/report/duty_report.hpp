// A duty in the forms of a report.
#pragma once

#include "report/report_forms.hpp"
#include "report/text_blocks.hpp"
#include "studies/duty/report/duty_record.hpp"

namespace kinestat {

/// The tables of the text.
TextBlocks duty_blocks(const DutyReportView& view);

FileReport make_duty_report(const DutyReportView& view, const ReportForms& forms);

}  // namespace kinestat
