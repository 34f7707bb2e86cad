#include "run/benchmark.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "io/mechanism_reader.hpp"
#include "io/yaml_tree.hpp"
#include "mechanism/bind.hpp"
#include "report/benchmark_report.hpp"
#include "run/each_file.hpp"
#include "run/internal/chosen_case.hpp"
#include "run/internal/extreme_networks.hpp"
#include "run/load.hpp"

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

class BenchmarkJob {
 public:
  BenchmarkJob(const BenchmarkChoice& choice, const Clock& clock)
      : choice_(choice), clock_(clock) {}

  // Empty iff an error was added.
  std::optional<FileReport> run(const std::string& path,
                                const Loaded& loaded,
                                const ReportForms& forms,
                                Diagnostics& found) const {
    const std::vector<Case>& all = loaded.mechanism.cases;
    const Case* const chosen = choose_case(all, choice_.case_label, found);
    if (chosen == nullptr && !choice_.case_label.empty()) {
      return std::nullopt;
    }
    std::vector<BenchmarkedCase> results;
    for (const Case& which : all) {
      if (choice_.case_label.empty() || &which == chosen) {
        results.push_back({.label = which.label,
                           .motion = trade_off(loaded, which, ProblemSide::motion),
                           .action = trade_off(loaded, which, ProblemSide::action)});
      }
    }
    return make_benchmark_report(path, loaded.description, results, forms, found);
  }

 private:
  TradeOff trade_off(const Loaded& loaded, const Case& which, ProblemSide side) const {
    return find_trade_off(loaded.mechanism, which, side, choice_.limits, clock_);
  }

  const BenchmarkChoice& choice_;
  const Clock& clock_;
};

}  // namespace

Outcome benchmark_files(const std::vector<std::string>& paths,
                        const BenchmarkChoice& choice,
                        const AnalyseOptions& options,
                        const Clock& clock) {
  const BenchmarkJob job(choice, clock);
  const std::vector<SourceFile> built_in =
      paths.empty() ? extreme_networks() : std::vector<SourceFile>();
  std::vector<std::string> names = paths;
  for (const SourceFile& one : built_in) {
    names.push_back(one.path);
  }
  return report_on_each_file(
      names,
      options,
      [&](const std::string& path, const ReportForms& forms, SourceFile& source, Diagnostics& found)
          -> std::optional<FileReport> {
        const auto at = std::ranges::find(built_in, path, &SourceFile::path);
        if (at != built_in.end()) {
          source = *at;
        }
        const std::optional<Loaded> loaded = at != built_in.end()
                                                 ? load_built_in(source, found)
                                                 : load(path, options.load, source, found);
        return loaded ? job.run(path, *loaded, forms, found) : std::nullopt;
      });
}

}  // namespace kinestat
