#include "run/tolerance.hpp"

#include "command.hpp"

namespace kinestat::app {

namespace {

struct ToleranceOptions {
  FileOptions files;
  ToleranceChoice choice;
};

void add_choice_options(CLI::App& command, ToleranceChoice& choice) {
  add_names(command,
            "--of",
            choice.positions,
            "the position to watch: a freedom d.wz, an\n"
            "actuator, a traced point P, a body, or a component\n"
            "of these two, P/at/x; several with commas between\n"
            "them; default: actuators that are not held and\n"
            "traced points, or all freedoms if there are none",
            "POSITION");
  with_value(command,
             command.add_option("--place",
                                choice.place,
                                "how far the location of a coupling in one part may\n"
                                "be from that in the other, to either side: 0.1mm"),
             "LENGTH");
  with_value(command,
             command.add_option(
                 "--angle", choice.angle, "the same for the angle of guides and axes: 0.05deg"),
             "ANGLE");
  add_repeated(command,
               "--each",
               choice.each,
               "tolerance of one coupling, instead of these, or of\n"
               "one held drive, which is otherwise exact:\n"
               "C=0.02mm, motor=0.1deg; may be repeated",
               "NAME=VALUE");
  add_flag(
      command,
      "--along",
      [&choice] { choice.along = true; },
      "at each step of the section motion, with its\n"
      "drives held; default: the drawn position");
  with_value(
      command, command.add_option("--case", choice.case_label, "one case; default: all"), "CASE");
}

}  // namespace

void add_tolerance(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat tolerance --place 0.1mm four_bar.yaml\n"
      "  kinestat tolerance --of d.wz --place 0.1mm --each motor=0.2deg four_bar.yaml\n"
      "  kinestat tolerance --of P/at/x --place 0.1mm --along --format csv six_bar.yaml\n");
  auto options = std::make_shared<ToleranceOptions>();
  add_files(command, options->files);
  add_curves(command, options->files.analyse.load);
  add_format(command, options->files);
  add_layout(command, options->files);
  add_strict(command, options->files);
  add_quiet(command, options->files);
  add_choice_options(command, options->choice);
  run_when_chosen(command, job, [options] {
    return tolerance_of_files(options->files.paths, options->choice, options->files.analyse);
  });
}

}  // namespace kinestat::app
