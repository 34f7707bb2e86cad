#include "studies/benchmark/report/benchmark_report.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "report/report_parts.hpp"
#include "report/table.hpp"
#include "studies/benchmark/report/benchmark_record.hpp"

namespace kinestat {

namespace {

struct Side {
  const char* key;
  const char* unit_words;  ///< of the dense equations
  TradeOff BenchmarkedCase::*result;
};

constexpr std::array<Side, 2> kSides = {{
    {.key = "motion", .unit_words = "M_NS of the circuits", .result = &BenchmarkedCase::motion},
    {.key = "action",
     .unit_words = "equilibrium of the bodies",
     .result = &BenchmarkedCase::action},
}};

// Why a side was left out, for people.
const char* sentence_of(NoProblem reason) {
  switch (reason) {
    case NoProblem::none:
      return "";
    case NoProblem::not_asked:
      return "nothing is known of them";
    case NoProblem::open:
      return "what is known does not determine some of them";
    case NoProblem::dependent:
      return "what is known contradicts itself";
    case NoProblem::too_large:
      return "too many of them for dense methods";
    case NoProblem::no_unknowns:
      return "all of them are known";
  }
  return "";
}

std::string error_cell(const ExtremeResult& result) {
  if (!result.error) {
    return std::string(text_of(result.status));
  }
  return *result.error == 0.0 ? "0" : fmt::format("{:.0e}", *result.error);
}

TextBlocks side_blocks(const BenchmarkedCase& one, const Side& side) {
  const TradeOff& result = one.*side.result;
  const std::string title = fmt::format("Case {}, {}s", one.label, side.key);
  if (result.reason != NoProblem::none) {
    return result.reason == NoProblem::not_asked
               ? TextBlocks()
               : TextBlocks(fmt::format("{}: skipped, {}\n\n", title, sentence_of(result.reason)));
  }
  std::vector<std::string> head = {"Method", "time [D]", "front"};
  for (const Extreme& extreme : kExtremes) {
    head.emplace_back(extreme.name);
  }
  Table table(std::move(head));
  for (const MethodResult& method : result.methods) {
    std::vector<std::string> row = {std::string(words_of(method.method)),
                                    fmt::format("{:.3g}", method.time),
                                    method.is_on_front ? "*" : ""};
    for (const ExtremeResult& extreme : method.extremes) {
      row.push_back(error_cell(extreme));
    }
    table.add(std::move(row));
  }
  TextBlocks blocks(fmt::format("{}: {} unknowns; D = dense LU in double ({}), {:.3g} µs here\n",
                                title,
                                result.unknowns,
                                side.unit_words,
                                1e6 * result.unit_seconds));
  return blocks += TextBlocks(std::move(table));
}

bool is_not_asked(const BenchmarkedCase& one) {
  return std::ranges::all_of(
      kSides, [&](const Side& side) { return (one.*side.result).reason == NoProblem::not_asked; });
}

bool is_measured(const BenchmarkedCase& one) {
  return std::ranges::any_of(
      kSides, [&](const Side& side) { return (one.*side.result).reason == NoProblem::none; });
}

TextBlocks case_blocks(const BenchmarkedCase& one) {
  if (is_not_asked(one)) {
    return TextBlocks(
        fmt::format("Case {}: skipped, neither motions nor actions are known\n\n", one.label));
  }
  TextBlocks blocks;
  for (const Side& side : kSides) {
    blocks += side_blocks(one, side);
  }
  return blocks;
}

TextBlocks blocks_of(const std::vector<BenchmarkedCase>& cases) {
  if (cases.empty()) {
    return TextBlocks("The file has no cases, so there is nothing to solve.\n");
  }
  TextBlocks blocks;
  for (const BenchmarkedCase& one : cases) {
    blocks += case_blocks(one);
  }
  if (std::ranges::none_of(cases, is_measured)) {
    return blocks += "Nothing was measured.\n";
  }
  return blocks +=
         "Errors are the largest against the exact solution of the same doubles, as a share of "
         "the\n"
         "largest unknown. front *: no other method is both faster and more accurate over all\n"
         "extremes.\n";
}

}  // namespace

FileReport make_benchmark_report(const std::string& file,
                                 const MechanismDescription& description,
                                 const std::vector<BenchmarkedCase>& cases,
                                 const ReportForms& forms,
                                 const Diagnostics& found) {
  FileReport report;
  const BenchmarkReportView view{
      .file = file, .description = description, .cases = cases, .found = &found};
  add_forms(benchmark_report_record, view, forms, report);
  if (forms.text) {
    report.text += (description.name.empty() ? file : description.name) + "\n\n";
    report.text += blocks_of(cases);
  }
  return report;
}

}  // namespace kinestat
