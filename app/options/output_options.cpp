#include "options/output_options.hpp"

namespace kinestat::app {

void add_output(CLI::App& command, AnalyseOptions& analyse, const std::string& explanation) {
  with_value(command, command.add_option("-o,--out", analyse.output.folder, explanation), "FOLDER");
  add_flag(
      command,
      "--force",
      [&analyse] { analyse.output.overwrite = Overwrite::force; },
      "replace files that this program did not write");
}

}  // namespace kinestat::app
