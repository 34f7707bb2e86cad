#include "command.hpp"

#include <array>
#include <utility>

namespace kinestat::app {

namespace {

constexpr std::array<Command, 24> kCommands = {{
    {"new", "Write a commented starter file.", add_new},
    {"examples",
     "List the published mechanisms in the library, or write one to a file.",
     add_examples},
    {"check", "Read and validate files; print 'ok' for each one that is well-formed.", add_check},
    {"analyze", "Solve the cases of the files: kinematics, statics, power flow.", add_analyze},
    {"graph", "Show the coupling graph: tree, circuits, cut-sets, matrices.", add_graph},
    {"mobility",
     "Show what can move, what is redundant, and which releases remove it.",
     add_mobility},
    {"inputs",
     "List sets of motions and actions that determine all others, best first.",
     add_inputs},
    {"shift", "List which clutches and brakes give which gear.", add_shift},
    {"duty", "Sum energies and losses of a duty cycle, and loads on gears and bearings.", add_duty},
    {"motion", "Move the mechanism through the ranges of its drives.", add_motion},
    {"simulate", "Simulate the motion in time that follows from the forces.", add_simulate},
    {"sensitivity", "Show how results depend on each parameter (derivatives).", add_sensitivity},
    {"tolerance", "Show position errors caused by deviations of parts and drives.", add_tolerance},
    {"sweep", "Analyse every combination of the parameters that a file varies.", add_sweep},
    {"merge", "Join the shards of a sweep into the complete result.", add_merge},
    {"synthesize",
     "Find linkages that guide a plane through positions; transmissions.",
     add_synthesize},
    {"report", "Write one HTML page with all results: text, tables, pictures.", add_report},
    {"compare", "Compare two reports by their numbers; exit status 1 if they differ.", add_compare},
    {"bench", "Measure what accuracy costs: time and error of each method.", add_bench},
    {"plot", "Draw one picture of a file: a chart, a graph or the mechanism.", add_plot},
    {"explain", "Explain a diagnostic code by an example, or list all codes.", add_explain},
    {"schema", "Print the JSON Schema of mechanism files or of an output.", add_schema},
    {"completion", "Print the completion script for bash, zsh or fish.", add_completion, true},
    {"help", "Explain a topic, a command, a key, a coupling type or a code.", add_help, true},
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
