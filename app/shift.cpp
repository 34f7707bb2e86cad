#include "run/shift.hpp"

#include "command.hpp"

namespace kinestat::app {

namespace {

struct ShiftFlags {
  FileOptions files;
  ShiftChoice choice;
};

}  // namespace

void add_shift(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat shift mechanisms/transmissions/ravigneaux_input_shaft.yaml\n"
      "  kinestat shift --one-more --one-fewer --format csv train.yaml\n");
  auto flags = std::make_shared<ShiftFlags>();
  add_files(command, flags->files);
  add_curves(command, flags->files.analyse.load);
  add_format(command, flags->files);
  add_layout(command, flags->files);
  add_accuracy(command, flags->files.analyse.accuracy);
  add_strict(command, flags->files);
  add_quiet(command, flags->files);
  add_flag(
      command,
      "--one-more",
      [flags] { flags->choice.one_more = true; },
      "also list combinations of one element more than a\n"
      "gear needs");
  add_flag(
      command,
      "--one-fewer",
      [flags] { flags->choice.one_fewer = true; },
      "also list combinations of one element fewer");
  run_when_chosen(command, job, [flags] {
    return shift_of_files(flags->files.paths, flags->choice, flags->files.analyse);
  });
}

}  // namespace kinestat::app
