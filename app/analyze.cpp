#include "command.hpp"

namespace kinestat::app {

void add_analyze(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat analyze mechanisms/planar/four_bar.yaml\n"
      "  kinestat analyze --out reports mechanisms/transmissions/*.yaml\n"
      "  kinestat analyze --format json --set Ns=24 train.yaml\n"
      "  generator | kinestat analyze --format csv -\n");
  auto options = std::make_shared<FileOptions>();
  AnalyseOptions& analyse = options->analyse;
  add_files(command, *options);
  add_curves(command, options->analyse.load);
  add_format(command, *options);
  add_layout(command, *options);
  add_accuracy(command, analyse.accuracy);
  add_output(command,
             analyse,
             "existing folder for <name>.report.json and one CSV\n"
             "table per pass");
  add_strict(command, *options);
  add_quiet(command, *options);
  add_fail_fast(command, *options);
  run_when_chosen(
      command, job, [options] { return analyse_files(options->paths, options->analyse); });
}

}  // namespace kinestat::app
