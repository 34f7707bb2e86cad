#include "run/analyse.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "report/file_report.hpp"
#include "run/findings.hpp"
#include "run/solve_cases.hpp"

namespace kinestat {

ReportForms stream_forms(StreamFormat format, std::size_t file_count) {
  const bool is_json = format == StreamFormat::json;
  return {.json = is_json && file_count == 1,
          .json_line = is_json && file_count > 1,
          .csv = format == StreamFormat::csv,
          .text = format == StreamFormat::table};
}

namespace {

ReportForms forms_of(const AnalyseOptions& options, std::size_t file_count) {
  ReportForms forms = options.is_quiet ? ReportForms{} : stream_forms(options.format, file_count);
  if (!options.output.folder.empty()) {
    forms.json = true;
    forms.csv = true;
  }
  return forms;
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
        const bool has_header = !outcome.out.empty();
        outcome.out += has_header ? table.text.substr(csv_signature().size()) : table.text;
      }
      break;
  }
}

void analyse_file(const std::string& path,
                  const AnalyseOptions& options,
                  const ReportForms& forms,
                  Outcome& outcome) {
  SourceFile source;
  Diagnostics found;
  if (std::optional<Loaded> loaded = load(path, options.overrides, source, found)) {
    const Analysis analysis = solve_cases(path, *std::move(loaded));
    add_findings(analysis, found);
    const FileReport report = make_report(analysis, forms, found);
    add_to_stream(report, options, outcome);
    if (!options.output.folder.empty()) {
      write_report(report, report_stem(path), options.output, found);
    }
  }
  add_diagnostics(source, found, options.strictness, outcome);
}

// Runs `job` for each file; a broken contract fails that file only.
template <class Job>
Outcome for_each_file(const std::vector<std::string>& paths,
                      const AnalyseOptions& options,
                      const Job& job) {
  Outcome outcome;
  Diagnostics found;
  if (!options.output.folder.empty() &&
      !(check_distinct(paths, found) && check_output_folder(options.output.folder, found))) {
    add_diagnostics({.path = "kinestat", .text = {}}, found, options.strictness, outcome);
    return outcome;
  }
  for (const std::string& path : paths) {
    try {
      job(path, outcome);
    } catch (const ContractViolation& bug) {
      add_bug(path, bug.what(), outcome);
    }
    if (options.fail_fast && outcome.status != ExitStatus::done) {
      break;
    }
  }
  return outcome;
}

}  // namespace

Outcome analyse_files(const std::vector<std::string>& paths, const AnalyseOptions& options) {
  const ReportForms forms = forms_of(options, paths.size());
  return for_each_file(paths, options, [&](const std::string& path, Outcome& outcome) {
    analyse_file(path, options, forms, outcome);
  });
}

Outcome check_files(const std::vector<std::string>& paths, const AnalyseOptions& options) {
  return for_each_file(paths, options, [&](const std::string& path, Outcome& outcome) {
    SourceFile source;
    Diagnostics found;
    if (load(path, options.overrides, source, found)) {
      outcome.out += fmt::format("{}: ok\n", path == "-" ? "<stdin>" : path);
    }
    add_diagnostics(source, found, options.strictness, outcome);
  });
}

}  // namespace kinestat
