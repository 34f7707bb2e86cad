#include "run/mobility.hpp"

#include "accuracy_options.hpp"
#include "command.hpp"

namespace kinestat::app {

void add_mobility(CLI::App& parent, Job& job) {
  CLI::App* command = parent.add_subcommand(
      "mobility", "Show what moves, what is redundant, and which releases would remove it.");
  command->footer(
      "  kinestat mobility mechanisms/spatial/bennett.yaml\n"
      "  kinestat mobility --format json mechanisms/planar/four_bar.yaml\n");
  auto options = std::make_shared<FileOptions>();
  add_files(*command, *options);
  add_format(*command, *options);
  add_accuracy(*command, options->analyse.accuracy);
  add_strict(*command, *options);
  command->callback([options, &job] {
    job = [options] { return mobility_of_files(options->paths, options->analyse); };
  });
}

}  // namespace kinestat::app
