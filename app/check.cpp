#include "command.hpp"

namespace kinestat::app {

void add_check(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat check train.yaml\n"
      "  kinestat check --strict mechanisms/*/*.yaml\n"
      "  kinestat check --diagnostics json - < train.yaml\n");
  auto options = std::make_shared<FileOptions>();
  add_files(command, *options);
  add_curves(command, options->analyse.load);
  add_strict(command, *options);
  add_fail_fast(command, *options);
  run_when_chosen(
      command, job, [options] { return check_files(options->paths, options->analyse); });
}

}  // namespace kinestat::app
