#include "accuracy_options.hpp"
#include "command.hpp"

namespace kinestat::app {

namespace {

void add_report_output(CLI::App& command, AnalyseOptions& analyse) {
  with_value(command,
             command.add_option("-o,--out",
                                analyse.output.folder,
                                "folder for <name>.report.json and one CSV\n"
                                "table a pass; it must exist"),
             "FOLDER");
  add_flag(
      command,
      "--force",
      [&analyse] { analyse.output.overwrite = Overwrite::force; },
      "replace files that this program did not write");
}

}  // namespace

void add_analyze(CLI::App& parent, Job& job) {
  CLI::App* command =
      parent.add_subcommand("analyze", "Run every pass that the cases of the files ask for.");
  command->footer(
      "  kinestat analyze mechanisms/planar/four_bar.yaml\n"
      "  kinestat analyze --out reports mechanisms/transmissions/*.yaml\n"
      "  kinestat analyze --format json --set Ns=24 train.yaml\n"
      "  generator | kinestat analyze --format csv -\n");
  auto options = std::make_shared<FileOptions>();
  AnalyseOptions& analyse = options->analyse;
  add_files(*command, *options);
  add_format(*command, *options);
  add_accuracy(*command, analyse.accuracy);
  add_report_output(*command, analyse);
  add_strict(*command, *options);
  add_flag(
      *command,
      "-q,--quiet",
      [&analyse] { analyse.is_quiet = true; },
      "print no report on standard output");
  add_fail_fast(*command, *options);
  command->callback([options, &job] {
    job = [options] { return analyse_files(options->paths, options->analyse); };
  });
}

}  // namespace kinestat::app
