#include "command.hpp"
#include "run/synthesis.hpp"

namespace kinestat::app {

void add_synthesize(CLI::App& parent, Job& job) {
  CLI::App* command = parent.add_subcommand(
      "synthesize", "Find the linkages that lead a plane through given positions.");
  command->footer(
      "  kinestat new synthesis task.yaml\n"
      "  kinestat synthesize task.yaml\n"
      "  kinestat synthesize --format json task.yaml\n");
  auto options = std::make_shared<FileOptions>();
  add_files(*command, *options);
  add_format(*command, *options);
  add_strict(*command, *options);
  command->callback([options, &job] {
    job = [options] { return synthesize_files(options->paths, options->analyse); };
  });
}

}  // namespace kinestat::app
