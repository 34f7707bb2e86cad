#include "run/mobility.hpp"

#include "command.hpp"

namespace kinestat::app {

void add_mobility(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat mobility mechanisms/spatial/bennett.yaml\n"
      "  kinestat mobility --format json mechanisms/planar/four_bar.yaml\n");
  auto options = std::make_shared<FileOptions>();
  add_files(command, *options);
  add_format(command, *options);
  add_accuracy(command, options->analyse.accuracy);
  add_strict(command, *options);
  add_quiet(command, *options);
  run_when_chosen(
      command, job, [options] { return mobility_of_files(options->paths, options->analyse); });
}

}  // namespace kinestat::app
