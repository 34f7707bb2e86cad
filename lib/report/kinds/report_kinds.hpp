// The reports on mechanism files, by kind.
#pragma once

#include <span>
#include <string_view>

#include "record/shape.hpp"
#include "report/json_values.hpp"

namespace kinestat {

struct ReportKind {
  std::string_view name;  ///< of its schema
  const RecordShape* record;
};

/// All kinds; the report of an analysis, of which some have but parts, is the last.
std::span<const ReportKind> report_kinds();

/// The record of a report by the keys that it has; that of an analysis where no other fits.
const RecordShape& record_of(const Json& report);

}  // namespace kinestat
