#include "run/inputs.hpp"

#include "command.hpp"
#include "options/sweep_options.hpp"

namespace kinestat::app {

namespace {

struct InputsOptions {
  FileOptions files;
  InputsChoice choice;
};

void add_choice_options(CLI::App& command, InputsChoice& choice) {
  add_names(command,
            "--among",
            choice.among,
            "a freedom, action or actuator that may be given;\n"
            "several with commas between them; default: all",
            "NAME");
  add_flag(
      command,
      "--actuators",
      [&choice] { choice.only_actuators = true; },
      "only motions and actions of actuators may be given");
  add_names(command,
            "--with",
            choice.required,
            "one that every set must contain; several with\n"
            "commas between them",
            "NAME");
  add_repeated(command,
               "--judge",
               choice.judged,
               "a set, separated by commas: reports whether it is\n"
               "valid and, if not, which circuit or cut-set it\n"
               "contains; may be repeated",
               "NAMES");
  add_count(
      command,
      "--limit",
      [&choice](std::uint64_t count) { choice.listed = count; },
      "maximum number of sets listed; default 20",
      0);
}

}  // namespace

void add_inputs(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat inputs crank.yaml\n"
      "  kinestat inputs --actuators --with in train.yaml\n"
      "  kinestat inputs --judge a.wz,d.wz crank.yaml\n");
  auto options = std::make_shared<InputsOptions>();
  add_files(command, options->files);
  add_format(command, options->files);
  add_strict(command, options->files);
  add_quiet(command, options->files);
  add_choice_options(command, options->choice);
  run_when_chosen(command, job, [options] {
    return inputs_files(options->files.paths, options->choice, options->files.analyse);
  });
}

}  // namespace kinestat::app
