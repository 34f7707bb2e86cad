#include "command.hpp"

namespace kinestat::app {

void add_analyze(CLI::App& parent, Job& job) {
  CLI::App* command = parent.add_subcommand(
      "analyze", "run every pass that the cases of the files ask for, and report");
  auto options = std::make_shared<FileOptions>();
  add_files(*command, *options);
  add_format(*command, *options);
  add_strict(*command, *options);
  AnalyseOptions& analyse = options->analyse;
  command
      ->add_option("-o,--out",
                   analyse.output.folder,
                   "folder for <name>.report.json and the CSV tables; it must exist")
      ->type_name("FOLDER");
  command->add_flag_callback(
      "--force",
      [&analyse] { analyse.output.overwrite = Overwrite::force; },
      "replace files that are not reports of this program");
  command->add_flag("-q,--quiet", analyse.is_quiet, "print no report on standard output");
  command->add_flag("--fail-fast", analyse.fail_fast, "stop after the first file that fails");
  command->footer(
      "Examples:\n"
      "  kinestat analyze mechanisms/planar/four_bar.yaml\n"
      "  kinestat analyze --out reports mechanisms/transmissions/*.yaml\n"
      "  kinestat analyze --format json --set N1=24 train.yaml");
  command->callback([options, &job] {
    job = [options] { return analyse_files(options->paths, options->analyse); };
  });
}

}  // namespace kinestat::app
