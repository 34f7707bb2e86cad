// The report of one file in the forms asked for.
#pragma once

#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "report/analysis.hpp"

namespace kinestat {

/// One CSV table under the name of its pass.
struct NamedTable {
  std::string pass;
  std::string text;
};

/// Which forms are wanted; the others stay empty.
struct ReportForms {
  bool json = false;
  bool json_line = false;  ///< the same on one line, for several files on one stream
  bool csv = false;
  bool text = false;
};

struct FileReport {
  std::string json;
  std::string json_line;
  std::vector<NamedTable> csv;
  std::string text;
};

/// What every JSON report of this program begins with; a file that begins otherwise is foreign.
std::string_view json_signature();

/// What every CSV table of this program begins with.
std::string_view csv_signature();

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
