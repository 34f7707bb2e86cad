// One sub-command each: add_x declares its options; what it does runs after parsing.
#pragma once

#include <functional>
#include <string>

#include "file_options.hpp"
#include "files/outcome.hpp"

namespace kinestat::app {

/// What the chosen sub-command will do; set while the command line is parsed.
using Job = std::function<Outcome()>;

void add_analyze(CLI::App& parent, Job& job);
void add_check(CLI::App& parent, Job& job);
void add_graph(CLI::App& parent, Job& job);
void add_mobility(CLI::App& parent, Job& job);
void add_inputs(CLI::App& parent, Job& job);
void add_shift(CLI::App& parent, Job& job);
void add_motion(CLI::App& parent, Job& job);
void add_sensitivity(CLI::App& parent, Job& job);
void add_sweep(CLI::App& parent, Job& job);
void add_merge(CLI::App& parent, Job& job);
void add_synthesize(CLI::App& parent, Job& job);
void add_report(CLI::App& parent, Job& job);
void add_compare(CLI::App& parent, Job& job);
void add_bench(CLI::App& parent, Job& job);
void add_plot(CLI::App& parent, Job& job);
void add_new(CLI::App& parent, Job& job);
void add_schema(CLI::App& parent, Job& job);
void add_explain(CLI::App& parent, Job& job);
void add_help(CLI::App& parent, Job& job);

}  // namespace kinestat::app
