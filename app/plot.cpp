#include "run/plot.hpp"

#include "command.hpp"
#include "terminal/seconds.hpp"

namespace kinestat::app {

namespace {

struct PlotCommand {
  FileOptions files;
  PlotChoice choice;
};

void add_choices(CLI::App& command, PlotChoice& choice) {
  with_value(command,
             command.add_option("--case,--gear",
                                choice.case_label,
                                "the case or gear to show; default: all, or the\n"
                                "first in pictures of a single one"),
             "CASE");
  add_repeated(command,
               "--at",
               choice.at,
               "draw the mechanism at this drive position, '30\n"
               "deg' from the drawn position; may be repeated: the\n"
               "first is drawn dark, the others light",
               "VALUE");
  with_value(command,
             command.add_option(
                 "--drive", choice.drive, "the driving actuator, instead of the one in the file"),
             "ACTUATOR");
  add_names(command,
            "--report",
            choice.report,
            "what charts of a motion show, instead of what the\n"
            "file says: a word from 'kinestat help motion', an\n"
            "actuator, or a column by its name, 'motor/action';\n"
            "several with commas between them",
            "QUANTITY");
  with_value(command,
             command.add_option("--over",
                                choice.over,
                                "the column over which motion-curves are drawn: a\n"
                                "drive, time, or one of the report, 'wheel/at/y';\n"
                                "default: the drive or, where it runs unsteadily\n"
                                "in time, time"),
             "QUANTITY");
  add_choice<PictureForm>(
      command,
      "--emit",
      {{"svg", PictureForm::svg}, {"dot", PictureForm::dot}, {"gnuplot", PictureForm::gnuplot}},
      choice.form,
      "svg, or text for other programs: dot for graphs,\n"
      "gnuplot for charts");
  with_value(command,
             command.add_option(
                 "-o,--out", choice.path, "file for the picture; default: -, standard output"),
             "FILE");
  add_flag(
      command,
      "--force",
      [&choice] { choice.overwrite = Overwrite::force; },
      "replace a file that this program did not write");
}

}  // namespace

void add_plot(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat plot list mechanisms/transmissions/ravigneaux.yaml\n"
      "  kinestat plot speeds -o speeds.svg mechanisms/transmissions/ravigneaux.yaml\n"
      "  kinestat plot linkage --at '30 deg' --at '90 deg' crank.yaml > crank.svg\n"
      "  kinestat plot motion-curves --report motor/action crank.yaml > torque.svg\n"
      "  kinestat plot motion-curves --over time press.yaml > over_time.svg\n"
      "  kinestat plot forces --case M2 --emit gnuplot train.yaml | gnuplot -p\n"
      "\nPictures:\n" +
      picture_help());
  auto options = std::make_shared<PlotCommand>();
  add_argument(command, "PICTURE", options->choice.picture, "one of the pictures above, or list")
      .required();
  add_files(command, options->files);
  add_curves(command, options->files.analyse.load);
  command.get_option("FILE")->expected(1)->description("a mechanism file; - is standard input");
  add_choices(command, options->choice);
  add_accuracy(command, options->files.analyse.accuracy);
  add_strict(command, options->files);
  run_when_chosen(command, job, [options] {
    PlotChoice choice = options->choice;
    choice.path = choice.path == kStandardOutput ? "" : choice.path;
    return plot_file(options->files.paths.front(), choice, options->files.analyse, seconds);
  });
}

}  // namespace kinestat::app
