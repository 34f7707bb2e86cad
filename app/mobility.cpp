#include "run/mobility.hpp"

#include "command.hpp"
#include "options/accuracy_options.hpp"

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
  command.callback([options, &job] {
    job = [options] { return mobility_of_files(options->paths, options->analyse); };
  });
}

}  // namespace kinestat::app
