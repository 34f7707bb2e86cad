#include "command.hpp"

#include <array>
#include <utility>

namespace kinestat::app {

namespace {

constexpr std::array<Command, 24> kCommands = {{
    {"new", "Write a commented mechanism file to begin with.", add_new},
    {"examples", "List the published mechanisms of the library, or write one.", add_examples},
    {"check", "Read and validate the files; say 'ok' for each that is well-formed.", add_check},
    {"analyze", "Run every pass that the cases of the files ask for.", add_analyze},
    {"graph", "Show the coupling graph: tree, circuits, cut-sets, matrices.", add_graph},
    {"mobility",
     "Show what moves, what is redundant, and which releases would remove it.",
     add_mobility},
    {"inputs", "List which motions and actions determine all others, the best first.", add_inputs},
    {"shift", "List which combination of clutches and brakes makes which gear.", add_shift},
    {"duty", "Sum what a duty cycle costs, and what it does to gears and bearings.", add_duty},
    {"motion", "Move the mechanism through the ranges of its drives.", add_motion},
    {"simulate",
     "Leave the mechanism to what acts on it: places, speeds, energies in time.",
     add_simulate},
    {"sensitivity", "Show how answers move with each parameter (derivatives).", add_sensitivity},
    {"tolerance", "Show how far positions are off where parts and drives are.", add_tolerance},
    {"sweep", "Analyse every combination of the parameters that a file varies.", add_sweep},
    {"merge", "Join the shards of a sweep to its whole result.", add_merge},
    {"synthesize", "Find the linkages that lead a plane through given positions.", add_synthesize},
    {"report", "Write one page with everything of the files: words, tables, pictures.", add_report},
    {"compare", "Compare two reports by their numbers; exit status 1 if they differ.", add_compare},
    {"bench", "Measure what accuracy costs: time and error of methods at extremes.", add_bench},
    {"plot", "Draw one picture of a file: charts, graphs, mechanisms.", add_plot},
    {"explain", "Explain a diagnostic code by an example, or list all codes.", add_explain},
    {"schema", "Print the JSON Schema of mechanism files and of what is written.", add_schema},
    {"completion",
     "Print the script by which bash, zsh or fish completes words.",
     add_completion,
     true},
    {"help", "Explain a topic, such as the format or the signs.", add_help, true},
}};

}  // namespace

void run_when_chosen(CLI::App& command, Job& job, Job run) {
  command.callback([run = std::move(run), &job] { job = run; });
}

const CLI::App* find_command(const CLI::App& app, const std::string& name) {
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == name) {
      return command;
    }
  }
  return nullptr;
}

std::span<const Command> commands() {
  return kCommands;
}

}  // namespace kinestat::app
