// One sub-command each: add_x declares its options; what it does runs after parsing.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "run/analyse.hpp"

namespace kinestat::app {

/// What the chosen sub-command will do; set while the command line is parsed.
using Job = std::function<Outcome()>;

/// The options that commands on mechanism files share.
struct FileOptions {
  std::vector<std::string> paths;
  AnalyseOptions analyse;
};

/// Declares FILE… and --set.
void add_files(CLI::App& command, FileOptions& options);

/// Declares --format.
void add_format(CLI::App& command, FileOptions& options);

/// Declares --strict.
void add_strict(CLI::App& command, FileOptions& options);

void add_analyze(CLI::App& parent, Job& job);
void add_check(CLI::App& parent, Job& job);
void add_graph(CLI::App& parent, Job& job);
void add_explain(CLI::App& parent, Job& job);

/// What is wrong with the command line, in the words of this program, for standard error.
std::string usage_error(const CLI::ParseError& problem, const CLI::App& app);

}  // namespace kinestat::app
