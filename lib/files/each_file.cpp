#include "files/each_file.hpp"

#include <exception>
#include <new>

namespace kinestat {

ReportForms stream_forms(StreamFormat format, std::size_t file_count) {
  const bool is_json = format == StreamFormat::json;
  return {.json = is_json && file_count == 1,
          .json_line = is_json && file_count > 1,
          .csv = format == StreamFormat::csv,
          .text = format == StreamFormat::table};
}

void add_to_stream(const FileReport& report, const AnalyseOptions& options, Outcome& outcome) {
  if (options.is_quiet) {
    return;
  }
  switch (options.format) {
    case StreamFormat::table:
      outcome.out += report.text;
      break;
    case StreamFormat::json:
      outcome.out += report.json_line.empty() ? report.json : report.json_line;
      break;
    case StreamFormat::csv:
      for (const NamedTable& table : report.csv) {
        const std::size_t header = table.text.find('\n') + 1;
        if (outcome.out.empty()) {
          outcome.out = table.text;
        } else if (outcome.out.starts_with(std::string_view(table.text).substr(0, header))) {
          outcome.out += table.text.substr(header);
        }
      }
      break;
  }
}

Outcome for_each_file(const std::vector<std::string>& paths,
                      const AnalyseOptions& options,
                      const FileJob& job) {
  Outcome outcome;
  outcome.form = options.diagnostics;
  Diagnostics found;
  if (!options.output.folder.empty() &&
      !(check_distinct(paths, found) && check_output_folder(options.output.folder, found))) {
    add_diagnostics({}, found, options.strictness, outcome);
    return outcome;
  }
  for (const std::string& path : paths) {
    try {
      job(path, outcome);
    } catch (const std::bad_alloc&) {
      throw;  // not of this file
    } catch (const std::exception& bug) {
      add_bug(path, bug.what(), outcome);
    }
    if (options.fail_fast && outcome.status != ExitStatus::done) {
      break;
    }
  }
  return outcome;
}

Outcome report_on_each_file(const std::vector<std::string>& paths,
                            const AnalyseOptions& options,
                            const FileAnswer& answer) {
  const ReportForms forms = stream_forms(options.format, paths.size());
  return for_each_file(paths, options, [&](const std::string& path, Outcome& outcome) {
    ReportedFile file{.path = path, .forms = forms};
    if (const std::optional<FileReport> report = answer(file)) {
      add_to_stream(*report, options, outcome);
    }
    add_diagnostics(file.source, file.found, options.strictness, outcome);
  });
}

}  // namespace kinestat
