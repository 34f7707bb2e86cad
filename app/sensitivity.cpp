#include "run/sensitivity.hpp"

#include "command.hpp"

namespace kinestat::app {

namespace {

struct SensitivityOptions {
  FileOptions files;
  SensitivityChoice choice;
};

void add_choice_options(CLI::App& command, SensitivityChoice& choice) {
  add_names(command,
            "--of",
            choice.values,
            "a result: ratio, torque_ratio, a freedom d.wz, an\n"
            "action c.Rx, or a path in the JSON report below\n"
            "the case; several with commas between them;\n"
            "default: ratios, and the rates and actions solved\n"
            "for actuators, or all rates and actions if there\n"
            "are no actuators",
            "VALUE");
  add_names(command,
            "--by",
            choice.parameters,
            "differentiate only by this parameter; several with\n"
            "commas between them; default: all",
            "PARAMETER");
  with_value(
      command, command.add_option("--case", choice.case_label, "one case; default: all"), "CASE");
}

}  // namespace

void add_sensitivity(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat sensitivity mechanisms/transmissions/ravigneaux.yaml\n"
      "  kinestat sensitivity --of ratio --of c.Rx --by frame_length crank.yaml\n"
      "  kinestat sensitivity --of kinematics/bodies/coupler/linear/0 crank.yaml\n");
  auto options = std::make_shared<SensitivityOptions>();
  add_files(command, options->files);
  add_curves(command, options->files.analyse.load);
  add_format(command, options->files);
  add_layout(command, options->files);
  add_strict(command, options->files);
  add_quiet(command, options->files);
  add_choice_options(command, options->choice);
  run_when_chosen(command, job, [options] {
    return sensitivity_files(options->files.paths, options->choice, options->files.analyse);
  });
}

}  // namespace kinestat::app
