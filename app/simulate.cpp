#include "command.hpp"
#include "run/simulation.hpp"

namespace kinestat::app {

void add_simulate(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat simulate pendulum.yaml\n"
      "  kinestat simulate --format csv --curve torque=motor.csv press.yaml\n");
  auto options = std::make_shared<FileOptions>();
  add_files(command, *options);
  add_curves(command, options->analyse.load);
  add_format(command, *options);
  add_strict(command, *options);
  run_when_chosen(
      command, job, [options] { return simulate_files(options->paths, options->analyse); });
}

}  // namespace kinestat::app
