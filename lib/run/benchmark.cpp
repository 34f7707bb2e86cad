#include "run/benchmark.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "cases/chosen_case.hpp"
#include "files/each_file.hpp"
#include "files/load_file.hpp"
#include "format/mechanism_reader.hpp"
#include "io/yaml_tree.hpp"
#include "mechanism/bind/bind.hpp"
#include "studies/benchmark/extreme.hpp"
#include "studies/benchmark/report/benchmark_report.hpp"

namespace kinestat {

namespace {

std::optional<Loaded> load_built_in(const SourceFile& source, Diagnostics& found) {
  const std::optional<YamlNode> tree = read_yaml(source, {}, found);
  std::optional<MechanismDescription> description =
      tree ? read_mechanism(*tree, found) : std::nullopt;
  std::optional<Mechanism> mechanism = description ? bind(*description, found) : std::nullopt;
  if (!mechanism) {
    return std::nullopt;
  }
  return Loaded{.description = *std::move(description),
                .mechanism = *std::move(mechanism),
                .shift = std::nullopt};
}

}  // namespace

std::optional<std::vector<BenchmarkedCase>> benchmark_cases(const Mechanism& mechanism,
                                                            const BenchmarkChoice& choice,
                                                            const Clock& clock,
                                                            Diagnostics& found) {
  const Case* const chosen = choose_case(mechanism.cases, choice.case_label, found);
  if (chosen == nullptr && !choice.case_label.empty()) {
    return std::nullopt;
  }
  const auto trade_off = [&](const Case& which, ProblemSide side) {
    return find_trade_off(mechanism, which, side, choice.limits, clock);
  };
  std::vector<BenchmarkedCase> results;
  for (const Case& which : mechanism.cases) {
    if (choice.case_label.empty() || &which == chosen) {
      results.push_back({.label = which.label,
                         .motion = trade_off(which, ProblemSide::motion),
                         .action = trade_off(which, ProblemSide::action)});
    }
  }
  return results;
}

Outcome benchmark_files(const std::vector<std::string>& paths,
                        const BenchmarkChoice& choice,
                        const AnalyseOptions& options,
                        const Clock& clock) {
  const std::vector<SourceFile> built_in =
      paths.empty() ? extreme_networks() : std::vector<SourceFile>();
  std::vector<std::string> names = paths;
  for (const SourceFile& one : built_in) {
    names.push_back(one.path);
  }
  return report_on_each_file(names, options, [&](ReportedFile& file) -> std::optional<FileReport> {
    const auto at = std::ranges::find(built_in, file.path, &SourceFile::path);
    if (at != built_in.end()) {
      file.source = *at;
    }
    const std::optional<Loaded> loaded =
        at != built_in.end() ? load_built_in(file.source, file.found)
                             : load(file.path, options.load, file.source, file.found);
    const auto results =
        loaded ? benchmark_cases(loaded->mechanism, choice, clock, file.found) : std::nullopt;
    return results ? std::optional(make_benchmark_report(
                         file.path, loaded->description, *results, file.forms, file.found))
                   : std::nullopt;
  });
}

}  // namespace kinestat
