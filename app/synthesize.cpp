#include "command.hpp"
#include "options/sweep_options.hpp"
#include "run/synthesis.hpp"
#include "usage_error.hpp"

namespace kinestat::app {

namespace {

struct SynthesizeCommand {
  FileOptions files;
  SynthesisOptions options;
};

void add_linkage_output(CLI::App& command, SynthesizeCommand& options) {
  with_value(command,
             command.add_option("--write-mechanism",
                                options.files.analyse.output.folder,
                                "folder for a mechanism file of every usable\n"
                                "linkage, <name>.linkage_0.yaml and so on;\n"
                                "it must exist"),
             "FOLDER");
  add_flag(
      command,
      "--all-linkages",
      [&options] { options.options.written = WrittenLinkages::all; },
      "write those with a defect or outside the\nlimits too; needs --write-mechanism");
  add_flag(
      command,
      "--force",
      [&options] { options.files.analyse.output.overwrite = Overwrite::force; },
      "replace files that this program did not\nwrite; needs --write-mechanism");
}

void add_digits(CLI::App& command, SynthesisOptions& options) {
  add_count(
      command,
      "--digits",
      [&options](std::uint64_t count) {
        if (count < kLeastDigits) {
          throw WrongValue("--digits",
                           std::to_string(count),
                           "it is 17 to 100; without it numbers have 16 digits");
        }
        if (count > kMostDigits) {
          throw WrongValue(
              "--digits", std::to_string(count), "it is 17 to 100, for example --digits 40");
        }
        options.digits = static_cast<int>(count);
      },
      "decimal digits that the positions have as\n"
      "typed, 17 to 100, where 16 leave too few of\n"
      "the dyads");
}

// What says how to write needs a place to write to.
void check_together(const CLI::App& command, const SynthesizeCommand& options) {
  for (const char* name : {"--all-linkages", "--force"}) {
    if (command.count(name) > 0 && options.files.analyse.output.folder.empty()) {
      throw LonelyOption(name,
                         "--write-mechanism",
                         "name the folder for the linkages, as in --write-mechanism linkages");
    }
  }
}

}  // namespace

void add_synthesize(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat new synthesis task.yaml\n"
      "  kinestat synthesize task.yaml\n"
      "  kinestat synthesize --format json task.yaml\n"
      "  kinestat synthesize --write-mechanism linkages task.yaml\n"
      "  kinestat synthesize --digits 40 close_positions.yaml\n");
  auto options = std::make_shared<SynthesizeCommand>();
  add_files(command, options->files);
  add_format(command, options->files);
  add_linkage_output(command, *options);
  add_flag(
      command,
      "--verify",
      [options] { options->options.verifies = true; },
      "move every linkage as a mechanism and report\nwhether it does what its verdict says; "
      "those\nthat are written are always moved");
  add_digits(command, options->options);
  add_count(
      command,
      "--jobs",
      [options](std::uint64_t count) { options->options.jobs = count; },
      "threads of a selection; default as many as\n"
      "there are cores. The result does not depend\n"
      "on it");
  add_strict(command, options->files);
  add_quiet(command, options->files);
  command.callback([options, &command, &job] {
    check_together(command, *options);
    job = [options] {
      return synthesize_files(options->files.paths, options->files.analyse, options->options);
    };
  });
}

}  // namespace kinestat::app
