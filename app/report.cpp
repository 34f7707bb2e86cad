#include <filesystem>

#include <fmt/format.h>

#include "command.hpp"
#include "core/utf8.hpp"
#include "run/html_report.hpp"
#include "terminal/page_opener.hpp"

namespace kinestat::app {

namespace {

struct ReportCommand {
  FileOptions files;
  HtmlReportOptions page;
  bool opens = false;
};

// "crank.html" beside crank.yaml; of several files, or of standard input, here.
std::string page_beside(const std::vector<std::string>& files) {
  return files.size() == 1 && files.front() != "-"
             ? std::filesystem::path(files.front()).replace_extension(".html").string()
             : "report.html";
}

void open_written(const std::string& page, Outcome& outcome) {
  if (outcome.status == ExitStatus::environment) {
    return;
  }
  const std::string reason = open_page(page);
  if (!reason.empty()) {
    add_message("E0152",
                fmt::format("'{}' cannot be opened by xdg-open: {}", printable(page), reason),
                "open it in a browser, or install xdg-utils",
                outcome);
  }
}

Outcome run_report(const ReportCommand& options) {
  HtmlReportOptions page = options.page;
  if (page.path == kStandardOutput && options.opens) {
    Outcome outcome;
    add_message("E0101",
                "--open shows a page in a file, and --out - writes it to standard output",
                "name a file, --out page.html, or leave --open out",
                outcome);
    return outcome;
  }
  if (page.path == kStandardOutput) {
    page.path.clear();
  } else if (page.path.empty() && (options.opens || writes_to_terminal())) {
    page.path = page_beside(options.files.paths);
  }
  Outcome outcome = html_report_of_files(options.files.paths, page, options.files.analyse);
  if (options.opens) {
    open_written(page.path, outcome);
  }
  return outcome;
}

}  // namespace

void add_report(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat report --out report.html mechanisms/transmissions/ravigneaux.yaml\n"
      "  kinestat report --out planar.html mechanisms/planar/*.yaml\n"
      "  kinestat report --open crank.yaml\n"
      "  kinestat report crank.yaml > crank.html\n");
  auto options = std::make_shared<ReportCommand>();
  AnalyseOptions& analyse = options->files.analyse;
  add_files(command, options->files);
  add_curves(command, options->files.analyse.load);
  with_value(command,
             command.add_option("-o,--out",
                                options->page.path,
                                "file for the page, which needs neither a network\n"
                                "nor other files; - is standard output, which is also\n"
                                "the default but on a terminal: there it is FILE.html\n"
                                "beside the mechanism file"),
             "FILE");
  add_flag(
      command, "--open", [options] { options->opens = true; }, "show the page in a browser");
  add_flag(
      command,
      "--force",
      [options] { options->page.overwrite = Overwrite::force; },
      "replace a file that this program did not write");
  add_accuracy(command, analyse.accuracy);
  add_strict(command, options->files);
  run_when_chosen(command, job, [options] { return run_report(*options); });
}

}  // namespace kinestat::app
