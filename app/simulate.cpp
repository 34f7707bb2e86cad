#include "command.hpp"
#include "run/simulation.hpp"

namespace kinestat::app {

void add_simulate(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat simulate pendulum.yaml\n"
      "  kinestat simulate --report action --format csv --layout wide pendulum.yaml\n"
      "  kinestat simulate --format csv --curve torque=motor.csv press.yaml\n");

  struct Flags {
    FileOptions files;
    std::vector<std::string> report;
  };

  auto flags = std::make_shared<Flags>();
  FileOptions& files = flags->files;
  add_files(command, files);
  add_curves(command, files.analyse.load);
  add_format(command, files);
  add_layout(command, files);
  add_names(command,
            "--report",
            flags->report,
            "what to report, instead of what the file says: a\n"
            "word from 'kinestat help simulation', an actuator,\n"
            "or a column by its name, 'a.Rx'; several with\n"
            "commas between them",
            "QUANTITY");
  add_strict(command, files);
  add_quiet(command, files);
  run_when_chosen(command, job, [flags] {
    return simulate_files(flags->files.paths, flags->report, flags->files.analyse);
  });
}

}  // namespace kinestat::app
