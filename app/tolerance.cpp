#include "run/tolerance.hpp"

#include "command.hpp"

namespace kinestat::app {

namespace {

struct ToleranceOptions {
  FileOptions files;
  ToleranceChoice choice;
};

void add_choice_options(CLI::App& command, ToleranceChoice& choice) {
  add_repeated(command,
               "--of",
               choice.positions,
               "a freedom d.wz, an actuator, a traced point P, a\n"
               "body, or a component of these two, P/at/x; may\n"
               "be repeated; default the actuators that are not\n"
               "held and the traced points, or all freedoms\n"
               "without any",
               "POSITION");
  with_value(command,
             command.add_option("--place",
                                choice.place,
                                "how far the place of a coupling in one part may\n"
                                "be from that in the other, to either side: 0.1mm"),
             "LENGTH");
  with_value(
      command,
      command.add_option("--angle", choice.angle, "likewise of guides and axes that tilt: 0.05deg"),
      "ANGLE");
  add_repeated(command,
               "--each",
               choice.each,
               "what one coupling has instead, or one drive that\n"
               "is held, which is exact otherwise: C=0.02mm,\n"
               "motor=0.1deg; may be repeated",
               "NAME=VALUE");
  add_flag(
      command,
      "--along",
      [&choice] { choice.along = true; },
      "at each step of the section motion, its drives\n"
      "held there; default the drawn position");
  with_value(
      command, command.add_option("--case", choice.case_label, "one case; default all"), "CASE");
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
  add_strict(command, options->files);
  add_quiet(command, options->files);
  add_choice_options(command, options->choice);
  run_when_chosen(command, job, [options] {
    return tolerance_of_files(options->files.paths, options->choice, options->files.analyse);
  });
}

}  // namespace kinestat::app
