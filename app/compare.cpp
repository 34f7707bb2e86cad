#include "run/compare.hpp"

#include "command.hpp"

namespace kinestat::app {

namespace {

struct TwoReports {
  std::string a;
  std::string b;
  CompareOptions options;
};

void add_reports(CLI::App& command, TwoReports& reports) {
  add_argument(
      command, "A", reports.a, "report that is expected: <name>.report.json, or a\nCSV table")
      .required();
  add_argument(command,
               "B",
               reports.b,
               "report that is compared with it; one of the two\nmay be -, standard input")
      .required();
}

void add_tolerances(CLI::App& command, ToleranceTexts& texts) {
  with_value(command,
             command.add_option("--rtol",
                                texts.rtol,
                                "equal within this share of the larger value;\n"
                                "default 1e-9"),
             "X");
  with_value(command,
             command.add_option("--atol",
                                texts.atol,
                                "equal within this much in the unit of A;\n"
                                "default 1e-12 of the largest value of the\n"
                                "kind in its case"),
             "X");
  CLI::Option& rule = with_value(command,
                                 command.add_option("--tolerance",
                                                    texts.tolerances,
                                                    "in place of both for one kind of quantity\n"
                                                    "(moment, angular_velocity, ratio, …) or for\n"
                                                    "a place and all below it (/cases/*/ratio,\n"
                                                    "where * is any one key). VALUE is in the\n"
                                                    "unit of A, or has a unit, or is a\n"
                                                    "percentage. Counts must be equal unless they\n"
                                                    "are named (count=1). May be repeated; the\n"
                                                    "last that fits decides"),
                                 "KEY=VALUE");
  rule.expected(1)->take_all()->allow_extra_args(false);
}

void add_form(CLI::App& command, CompareOptions& options) {
  add_choice<StreamFormat>(command,
                           "--format",
                           {{"table", StreamFormat::table}, {"json", StreamFormat::json}},
                           options.format,
                           "form of the differences on standard output");
  add_diagnostics_form(command, options.diagnostics);
  add_flag(
      command,
      "-q,--quiet",
      [&options] { options.is_quiet = true; },
      "print nothing; the exit status tells");
}

}  // namespace

void add_compare(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat compare golden/train.report.json reports/train.report.json\n"
      "  kinestat analyze --format json train.yaml | kinestat compare golden.json -\n"
      "  kinestat compare --rtol 1e-6 --tolerance 'moment=0.5 N*mm' old.json new.json\n"
      "  kinestat compare --tolerance '/cases/*/ratio=0.1%' --format json old.json new.json\n");
  auto reports = std::make_shared<TwoReports>();
  add_reports(command, *reports);
  add_tolerances(command, reports->options.tolerances);
  add_form(command, reports->options);
  run_when_chosen(command, job, [reports] {
    return compare_reports(reports->a, reports->b, reports->options);
  });
}

}  // namespace kinestat::app
