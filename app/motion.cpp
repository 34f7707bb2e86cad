#include "run/motion.hpp"

#include "command.hpp"

namespace kinestat::app {

namespace {

struct MotionFlags {
  FileOptions files;
  MotionChoice choice;
};

void add_motion_choice(CLI::App& command, MotionChoice& choice) {
  with_value(command,
             command.add_option("--drive",
                                choice.drive,
                                "the driving actuator, instead of the one in the\n"
                                "file; requires --to for its motion"),
             "ACTUATOR");
  with_value(command,
             command.add_option("--from",
                                choice.from,
                                "where its motion starts, measured from the drawn\n"
                                "position"),
             "VALUE");
  with_value(command,
             command.add_option("--to",
                                choice.to,
                                "where it ends: '90 deg', '20 mm', 1.5; limit or\n"
                                "-limit: where the drive reverses"),
             "VALUE");
  with_value(command, command.add_option("--steps", choice.steps, "number of steps"), "N");
  with_value(command,
             command.add_option("--case", choice.label, "the case whose speeds and loads apply"),
             "CASE");
  add_names(command,
            "--report",
            choice.report,
            "what to report, instead of what the file says: a\n"
            "word from 'kinestat help motion', an actuator, or\n"
            "a column by its name, 'motor/action'; several with\n"
            "commas between them",
            "QUANTITY");
}

}  // namespace

void add_motion(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat motion mechanisms/planar/four_bar.yaml\n"
      "  kinestat motion --format csv mechanisms/planar/slider_crank.yaml\n"
      "  kinestat motion --drive Tin --to '90 deg' --steps 45 crank.yaml\n");
  auto flags = std::make_shared<MotionFlags>();
  AnalyseOptions& analyse = flags->files.analyse;
  add_files(command, flags->files);
  add_curves(command, flags->files.analyse.load);
  add_format(command, flags->files);
  add_layout(command, flags->files);
  add_motion_choice(command, flags->choice);
  add_output(command,
             analyse,
             "existing folder for <name>.motion.json and\n"
             "<name>.motion.csv");
  add_strict(command, flags->files);
  add_quiet(command, flags->files);
  add_fail_fast(command, flags->files);
  run_when_chosen(command, job, [flags] {
    return motion_of_files(flags->files.paths, flags->choice, flags->files.analyse);
  });
}

}  // namespace kinestat::app
