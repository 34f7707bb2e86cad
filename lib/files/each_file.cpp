#include "files/each_file.hpp"

#include <array>
#include <exception>
#include <new>

#include "core/utf8.hpp"
#include "report/csv.hpp"
#include "report/table_archive.hpp"

namespace kinestat {

namespace {

// The heads of the columns alone, where there is nothing to tell.
const std::vector<NamedTable>& no_rows() {
  static const std::vector<NamedTable> table = {{.pass = {}, .text = std::string(kCsvHeader)}};
  return table;
}

// A line end within quotes ends no row.
std::string with_file_column(const std::string& table, const std::string& path) {
  std::string cell;
  append_csv_cell(printable(path), cell);
  cell += ',';
  std::string text = "file,";
  bool is_quoted = false;
  for (std::size_t i = 0; i < table.size(); ++i) {
    text += table[i];
    is_quoted ^= table[i] == '"';
    if (table[i] == '\n' && !is_quoted && i + 1 < table.size()) {
      text += cell;
    }
  }
  return text;
}

}  // namespace

ReportForms stream_forms(StreamFormat format, std::size_t file_count) {
  const bool is_json = format == StreamFormat::json;
  return {.json = is_json && file_count == 1,
          .json_line = is_json && file_count > 1,
          .csv = format == StreamFormat::csv,
          .text = format == StreamFormat::table};
}

void add_to_stream(const FileReport& report,
                   const std::string& path,
                   const std::vector<std::string>& paths,
                   const AnalyseOptions& options,
                   Outcome& outcome) {
  if (options.is_quiet) {
    return;
  }
  switch (options.format) {
    case StreamFormat::table:
      outcome.report += report.text;
      break;
    case StreamFormat::json:
      outcome.out += report.json_line.empty() ? report.json : report.json_line;
      break;
    case StreamFormat::csv:
      for (const NamedTable& table : report.csv.empty() ? no_rows() : report.csv) {
        const std::string text = paths.size() > 1 ? with_file_column(table.text, path) : table.text;
        const std::size_t header = text.find('\n') + 1;
        if (outcome.out.empty()) {
          outcome.out = text;
        } else if (outcome.out.starts_with(std::string_view(text).substr(0, header))) {
          outcome.out += text.substr(header);
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
  const bool has_tables = options.format == StreamFormat::csv || !options.output.folder.empty();
  if (options.output.layout != TableLayout::tidy && !has_tables) {
    add_message("E0101",
                "--layout is that of tables, and none are written",
                "give --format csv, or --out FOLDER",
                outcome);
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
  if (options.format == StreamFormat::csv) {
    outcome.out = laid_out(outcome.out, options.output.layout);
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
      add_to_stream(*report, path, paths, options, outcome);
    }
    add_diagnostics(file.source, file.found, options.strictness, outcome);
  });
}

}  // namespace kinestat
