#include "run/duty.hpp"

#include "command.hpp"

namespace kinestat::app {

namespace {

struct DutyOptions {
  FileOptions files;
  std::string cycle;
};

}  // namespace

void add_duty(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat duty gearbox.yaml\n"
      "  kinestat duty --cycle wltc.csv --format json gearbox.yaml\n");
  auto options = std::make_shared<DutyOptions>();
  add_files(command, options->files);
  add_curves(command, options->files.analyse.load);
  add_format(command, options->files);
  add_layout(command, options->files);
  add_strict(command, options->files);
  add_quiet(command, options->files);
  with_value(command,
             command.add_option("--cycle",
                                options->cycle,
                                "a table of points to use instead of those in the\n"
                                "file: CSV with columns case, duration [s] or time\n"
                                "[s], and actuators with their units"),
             "FILE");
  run_when_chosen(command, job, [options] {
    return duty_of_files(options->files.paths, options->cycle, options->files.analyse);
  });
}

}  // namespace kinestat::app
