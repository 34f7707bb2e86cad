// All JSON that the program writes, and pages of help on it.
#pragma once

#include <string>
#include <vector>

#include "report/kinds/report_kinds.hpp"

namespace kinestat {

std::vector<ReportKind> written_reports();

/// Of what there is a page of keys: parts of the report of an analysis, and reports.
std::vector<std::string> report_pages();

/// Its keys; empty if there is none of that name.
std::string report_page(const std::string& name);

/// The keys of the report of an analysis, without those that have a page.
std::string report_keys();

}  // namespace kinestat
