#include "command.hpp"

namespace kinestat::app {

void add_check(CLI::App& parent, Job& job) {
  CLI::App* command =
      parent.add_subcommand("check", "read and validate the files, without analysing them");
  auto options = std::make_shared<FileOptions>();
  add_files(*command, *options);
  add_strict(*command, *options);
  command->callback([options, &job] {
    job = [options] { return check_files(options->paths, options->analyse); };
  });
}

}  // namespace kinestat::app
