// The commands: add_x declares the options of one; what it does runs after parsing.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "files/outcome.hpp"
#include "options/file_options.hpp"

namespace kinestat::app {

/// What the chosen sub-command will do; set while the command line is parsed.
using Job = std::function<Outcome()>;

/// Has the parser set `job` to `run` when it meets the command.
void run_when_chosen(CLI::App& command, Job& job, Job run);

void add_analyze(CLI::App& command, Job& job);
void add_check(CLI::App& command, Job& job);
void add_graph(CLI::App& command, Job& job);
void add_mobility(CLI::App& command, Job& job);
void add_inputs(CLI::App& command, Job& job);
void add_shift(CLI::App& command, Job& job);
void add_motion(CLI::App& command, Job& job);
void add_duty(CLI::App& command, Job& job);
void add_sensitivity(CLI::App& command, Job& job);
void add_tolerance(CLI::App& command, Job& job);
void add_simulate(CLI::App& command, Job& job);
void add_sweep(CLI::App& command, Job& job);
void add_merge(CLI::App& command, Job& job);
void add_synthesize(CLI::App& command, Job& job);
void add_report(CLI::App& command, Job& job);
void add_compare(CLI::App& command, Job& job);
void add_bench(CLI::App& command, Job& job);
void add_plot(CLI::App& command, Job& job);
void add_new(CLI::App& command, Job& job);
void add_examples(CLI::App& command, Job& job);
void add_schema(CLI::App& command, Job& job);
void add_explain(CLI::App& command, Job& job);
void add_completion(CLI::App& command, Job& job);
void add_help(CLI::App& command, Job& job);

/// The command of that name, or null.
const CLI::App* find_command(const CLI::App& app, const std::string& name);

struct Command {
  std::string_view name;
  std::string_view summary;  ///< one line, for the list of commands
  void (*add_options)(CLI::App& command, Job& job);
  bool looks_at_others = false;  ///< at what the other commands declare
};

/// In the order of help.
std::span<const Command> commands();

}  // namespace kinestat::app
