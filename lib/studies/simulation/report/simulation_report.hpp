// A simulation in the forms of a report.
#pragma once

#include "report/report_forms.hpp"
#include "report/text_blocks.hpp"
#include "studies/simulation/report/simulation_record.hpp"

namespace kinestat {

/// The header of the table is that of motions; no drive has a position in it.
inline constexpr std::string_view kSimulationCsvHeader =
    "mechanism,case,pass,element,quantity,value,unit,status,step,drive\n";

/// The text in parts, in their order.
struct SimulationBlocks {
  TextBlocks end;       ///< how it ended, how well it balances, and what happened on the way
  TextBlocks extremes;  ///< empty where every column is always 0
  TextBlocks rows;      ///< a choice of them
};

SimulationBlocks simulation_blocks(const SimulationReportView& view);

FileReport make_simulation_report(const SimulationReportView& view, const ReportForms& forms);

}  // namespace kinestat
