#include "command.hpp"
#include "run/html_report.hpp"

namespace kinestat::app {

namespace {

struct ReportCommand {
  FileOptions files;
  HtmlReportOptions page;
};

}  // namespace

void add_report(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat report --out report.html mechanisms/transmissions/ravigneaux.yaml\n"
      "  kinestat report --out planar.html mechanisms/planar/*.yaml\n"
      "  kinestat report crank.yaml > crank.html\n");
  auto options = std::make_shared<ReportCommand>();
  AnalyseOptions& analyse = options->files.analyse;
  add_files(command, options->files);
  with_value(command,
             command.add_option("-o,--out",
                                options->page.path,
                                "file for the page, which needs no network and\n"
                                "no other file; without it the page goes to\n"
                                "standard output"),
             "FILE");
  add_flag(
      command,
      "--force",
      [options] { options->page.overwrite = Overwrite::force; },
      "replace a file that this program did not write");
  add_accuracy(command, analyse.accuracy);
  add_strict(command, options->files);
  run_when_chosen(command, job, [options] {
    return html_report_of_files(options->files.paths, options->page, options->files.analyse);
  });
}

}  // namespace kinestat::app
