#include "command.hpp"
#include "run/synthesis.hpp"

namespace kinestat::app {

namespace {

struct SynthesizeOptions : FileOptions {
  WrittenLinkages written = WrittenLinkages::usable;
};

void add_output(CLI::App& command, SynthesizeOptions& options) {
  with_value(command,
             command.add_option("--write-mechanism",
                                options.analyse.output.folder,
                                "folder for a mechanism file of every usable\n"
                                "linkage, <name>.linkage_0.yaml and so on;\n"
                                "it must exist"),
             "FOLDER");
  add_flag(
      command,
      "--all-linkages",
      [&options] { options.written = WrittenLinkages::all; },
      "write those with a defect or outside the\nlimits too");
  add_flag(
      command,
      "--force",
      [&options] { options.analyse.output.overwrite = Overwrite::force; },
      "replace files that this program did not write");
}

}  // namespace

void add_synthesize(CLI::App& parent, Job& job) {
  CLI::App* command = parent.add_subcommand(
      "synthesize", "Find the linkages that lead a plane through given positions.");
  command->footer(
      "  kinestat new synthesis task.yaml\n"
      "  kinestat synthesize task.yaml\n"
      "  kinestat synthesize --format json task.yaml\n"
      "  kinestat synthesize --write-mechanism linkages task.yaml\n");
  auto options = std::make_shared<SynthesizeOptions>();
  add_files(*command, *options);
  add_format(*command, *options);
  add_output(*command, *options);
  add_strict(*command, *options);
  command->callback([options, &job] {
    job = [options] {
      return synthesize_files(options->paths, options->written, options->analyse);
    };
  });
}

}  // namespace kinestat::app
