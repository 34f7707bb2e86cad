// One job on every file of a command line, and its report on standard output.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "files/file_options.hpp"
#include "report/report_forms.hpp"

namespace kinestat {

/// Adds what becomes of one file to the outcome.
using FileJob = std::function<void(const std::string& path, Outcome& outcome)>;

/// Checks the output folder if there is one, then runs the job for each file. A bug fails that file
/// only.
Outcome for_each_file(const std::vector<std::string>& paths,
                      const AnalyseOptions& options,
                      const FileJob& job);

/// A file of a command line on the way to its report.
struct ReportedFile {
  const std::string& path;
  const ReportForms& forms;
  SourceFile source = {};
  Diagnostics found = {};  ///< complaints about it, whose places are in the source
};

/// The report on one file, empty if there is none.
using FileAnswer = std::function<std::optional<FileReport>(ReportedFile& file)>;

/// The same for a job whose outcome is a report on standard output, with the diagnostics.
Outcome report_on_each_file(const std::vector<std::string>& paths,
                            const AnalyseOptions& options,
                            const FileAnswer& answer);

/// The forms that go to standard output for that many files.
ReportForms stream_forms(StreamFormat format, std::size_t file_count);

/// Appends the form that standard output wants; of several CSV tables only the first has a header,
/// and those with other columns than the first, such as the steps of a motion, are left out. Where
/// `paths`, those of the command line, are several, the first column of a table is `file`.
void add_to_stream(const FileReport& report,
                   const std::string& path,
                   const std::vector<std::string>& paths,
                   const AnalyseOptions& options,
                   Outcome& outcome);

}  // namespace kinestat
