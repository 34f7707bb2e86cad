// The files of a report in the folder that the user names.
#pragma once

#include <string>
#include <vector>

#include "core/diagnostic.hpp"
#include "io/atomic_file.hpp"
#include "report/report_forms.hpp"
#include "report/tables/wide_table.hpp"

namespace kinestat {

/// What to write where; an empty folder writes nothing.
struct OutputOptions {
  std::string folder;
  Overwrite overwrite = Overwrite::own_only;
  TableLayout layout = TableLayout::tidy;  ///< of tables, also on standard output
};

/// The name of the files of a report: the input's file name without its folder and ".yaml";
/// "stdin" for standard input.
std::string report_stem(const std::string& path);

/// Complains about inputs whose reports would have the same name.
bool check_distinct(const std::vector<std::string>& paths, Diagnostics& found);

/// A tidy table in that layout.
std::string laid_out(const std::string& tidy, TableLayout layout);

/// Writes <stem>.report.json and <stem>.<pass>.csv, all or none, and none of the inputs.
bool write_report(const FileReport& report,
                  const std::string& stem,
                  const OutputOptions& options,
                  InputPaths inputs,
                  Diagnostics& found);

}  // namespace kinestat
