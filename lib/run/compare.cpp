#include "run/compare.hpp"

#include <future>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/page_text.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "io/read_file.hpp"
#include "studies/compare/compare.hpp"
#include "studies/compare/compare_report.hpp"
#include "studies/compare/compare_text.hpp"
#include "studies/compare/ignored_keys.hpp"

namespace kinestat {

namespace {

// Twice that of a mechanism of the largest size that is read, for long motions.
constexpr std::size_t kLargestReport = std::size_t{64} << 20U;

std::optional<SourceFile> read_source(const std::string& path, Diagnostics& found) {
  Diagnostics wrong;
  std::optional<SourceFile> source = read_file(path, {.bytes = kLargestReport}, wrong);
  for (const Diagnostic& one : wrong.items()) {
    const bool is_size = one.code == "E0201";
    found.error(one.code,
                one.where,
                one.message,
                is_size ? "check the file name; a report is far smaller" : one.hint);
  }
  return source;
}

// One of the two, with what is wrong with it.
struct ReadReport {
  SourceFile source;
  Diagnostics found;
  std::optional<ReportValues> report;
};

ReadReport read_report_file(const std::string& path) {
  ReadReport result{.source = {.path = path, .text = {}}, .found = {}, .report = {}};
  if (std::optional<SourceFile> file = read_source(path, result.found)) {
    result.source = *std::move(file);
    result.report = read_report(result.source, result.found);
  }
  return result;
}

// Complains about what is wrong with the command line.
std::optional<Tolerances> read_options(const std::string& path_a,
                                       const std::string& path_b,
                                       const ToleranceTexts& texts,
                                       Outcome& outcome) {
  Diagnostics found;
  if (path_a == "-" && path_b == "-") {
    found.error("E0101",
                {},
                "standard input can be only one of the two reports",
                "write one of them to a file");
  }
  std::optional<Tolerances> tolerances = read_tolerances(texts, found);
  if (found.has_errors()) {
    add_diagnostics({}, found, Strictness::normal, outcome);
    return {};
  }
  return tolerances;
}

void write_comparison(const ReportComparison& comparison,
                      const std::string& path_a,
                      const std::string& path_b,
                      const CompareOptions& options,
                      Outcome& outcome) {
  if (options.is_quiet) {
    return;
  }
  if (options.format == StreamFormat::json) {
    outcome.out = comparison_json(comparison, path_a, path_b);
  } else {
    outcome.report = comparison_blocks(comparison);
  }
}

void warn_of_unmet_places(const ReportComparison& comparison, Outcome& outcome) {
  Diagnostics found;
  for (const std::string& place : comparison.unmet_places) {
    found.warning("W0901",
                  {},
                  fmt::format("--tolerance '{}': no value is there or below", printable(place)),
                  "'kinestat compare --format json' and the JSON report name the places");
  }
  if (!found.items().empty()) {
    add_diagnostics({}, found, Strictness::normal, outcome);
  }
}

}  // namespace

std::string ignored_keys_help() {
  const std::vector<std::string> keys = ignored_keys();
  return page_lines("  ", plain_list(keys, keys.size()), 2);
}

Outcome compare_reports(const std::string& path_a,
                        const std::string& path_b,
                        const CompareOptions& options) {
  Outcome outcome;
  outcome.form = options.diagnostics;
  const auto tolerances = read_options(path_a, path_b, options.tolerances, outcome);
  if (!tolerances) {
    return outcome;
  }
  // Nearly all of the time goes into reading: side by side where there are two cores.
  std::future<ReadReport> other = std::async([&] { return read_report_file(path_b); });
  const ReadReport read_a = read_report_file(path_a);
  const ReadReport read_b = other.get();
  for (const ReadReport* one : {&read_a, &read_b}) {
    add_diagnostics(one->source, one->found, Strictness::normal, outcome);
  }
  const std::optional<ReportValues>& a = read_a.report;
  const std::optional<ReportValues>& b = read_b.report;
  if (!a || !b) {
    return outcome;
  }
  if (a->form() != b->form()) {
    add_message(
        "E0905", "one report is JSON, the other a table", "compare two files of one kind", outcome);
    return outcome;
  }
  const ReportComparison comparison = compare(*a, *b, *tolerances);
  write_comparison(comparison, path_a, path_b, options, outcome);
  warn_of_unmet_places(comparison, outcome);
  if (!comparison.differences.empty()) {
    outcome.status = worst(outcome.status, ExitStatus::check_failed);
  }
  return outcome;
}

}  // namespace kinestat
