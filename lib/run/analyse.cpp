#include "run/analyse.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cases/exact_input_cases.hpp"
#include "cases/findings/case_findings.hpp"
#include "cases/findings/certainty_findings.hpp"
#include "core/utf8.hpp"
#include "files/each_file.hpp"
#include "mechanism/bind/bind.hpp"
#include "report/file/file_report.hpp"
#include "studies/motion/task/find_motion.hpp"
#include "studies/shift/task/gear_cases.hpp"
#include "studies/synthesis/task/find_synthesis.hpp"
#include "studies/transmissions/task/find_transmissions.hpp"

namespace kinestat {

namespace {

ReportForms forms_of(const AnalyseOptions& options, std::size_t file_count) {
  ReportForms forms = options.is_quiet ? ReportForms{} : stream_forms(options.format, file_count);
  if (!options.output.folder.empty()) {
    forms.json = true;
    forms.csv = true;
  }
  return forms;
}

void analyse_file(const std::string& path,
                  const std::vector<std::string>& paths,
                  const AnalyseOptions& options,
                  const ReportForms& forms,
                  Outcome& outcome) {
  SourceFile source;
  Diagnostics found;
  std::optional<MechanismDescription> description =
      load_description(path, options.load, source, found);
  if (description) {
    const std::optional<FileReport> report =
        analyse_description(path, *std::move(description), options.accuracy, forms, found);
    if (report) {
      add_to_stream(*report, path, paths, options, outcome);
      if (!options.output.folder.empty()) {
        write_report(
            *report, report_stem(path), options.output, input_paths(paths, options.load), found);
      }
    }
  }
  add_diagnostics(source, found, options.strictness, outcome);
}

bool check_task(const MechanismDescription& description, Diagnostics& found) {
  return description.synthesis->transmission
             ? read_transmission_task(description, found).has_value()
             : check_synthesis_task(description, found);
}

}  // namespace

std::optional<FileReport> analyse_description(const std::string& path,
                                              MechanismDescription description,
                                              const AccuracyRequest& accuracy,
                                              const ReportForms& forms,
                                              Diagnostics& found) {
  std::optional<Mechanism> mechanism = bind(description, found);
  if (description.synthesis && !found.has_errors()) {
    found.warning("W0302",
                  description.synthesis->where,
                  "section 'synthesis' is left to a command of its own",
                  "'kinestat synthesize' answers it");
  }
  if (mechanism) {
    const auto certified = analyse_mechanism(path,
                                             {.description = std::move(description),
                                              .mechanism = *std::move(mechanism),
                                              .shift = std::nullopt},
                                             accuracy,
                                             found);
    if (!certified) {
      return std::nullopt;
    }
    const Analysis& analysis = certified->analysis;
    const std::optional<FoundMotion> motion =
        analysis.description.motion ? find_motion(analysis.description, analysis.mechanism, found)
                                    : std::nullopt;
    return make_report(
        analysis, certified->certainty, motion ? &motion->table : nullptr, forms, found);
  }
  const bool is_right = std::ranges::all_of(found.items(), [](const Diagnostic& one) {
    return one.severity == Severity::warning || one.code == "E0315";
  });
  return is_right ? std::optional(make_head_report(path, description, forms, found)) : std::nullopt;
}

std::optional<CertifiedAnalysis> analyse_mechanism(const std::string& path,
                                                   Loaded loaded,
                                                   const AccuracyRequest& accuracy,
                                                   Diagnostics& found) {
  loaded.shift = add_gears(loaded.description, loaded.mechanism, {}, found);
  check_exact_input(loaded.description, loaded.mechanism, accuracy, found);
  if (found.has_errors()) {
    return std::nullopt;
  }
  CertifiedAnalysis certified = solve_certified_cases(path, std::move(loaded), accuracy);
  add_certainty_findings(certified.analysis, certified.certainty, found);
  add_findings(certified.analysis, found);
  return certified;
}

Outcome analyse_files(const std::vector<std::string>& paths, const AnalyseOptions& options) {
  const ReportForms forms = forms_of(options, paths.size());
  return for_each_file(paths, options, [&](const std::string& path, Outcome& outcome) {
    analyse_file(path, paths, options, forms, outcome);
  });
}

Outcome check_files(const std::vector<std::string>& paths, const AnalyseOptions& options) {
  return for_each_file(paths, options, [&](const std::string& path, Outcome& outcome) {
    SourceFile source;
    Diagnostics found;
    const auto description = load_description(path, options.load, source, found);
    const bool is_right = description && check(*description, found) &&
                          (!description->synthesis || check_task(*description, found));
    if (is_right && status_of(found, options.strictness) == ExitStatus::done) {
      outcome.out += fmt::format("{}: ok\n", path == "-" ? "<stdin>" : printable(path));
    }
    add_diagnostics(source, found, options.strictness, outcome);
  });
}

}  // namespace kinestat
