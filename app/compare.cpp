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
  add_argument(command,
               "A",
               reports.a,
               "the expected report: <name>.report.json, or rows or\n"
               "a table in CSV, of one file or of several")
      .required();
  add_argument(command,
               "B",
               reports.b,
               "the report to compare with it; one of the two may\n"
               "be -, standard input")
      .required();
}

void add_tolerances(CLI::App& command, ToleranceTexts& texts) {
  with_value(command,
             command.add_option("--rtol",
                                texts.rtol,
                                "relative tolerance, a fraction of the larger\n"
                                "value; default 1e-9"),
             "X");
  with_value(command,
             command.add_option("--atol",
                                texts.atol,
                                "absolute tolerance in the unit of A; default 1e-12\n"
                                "of the largest value of the same kind in its case"),
             "X");
  CLI::Option& rule =
      with_value(command,
                 command.add_option("--tolerance",
                                    texts.tolerances,
                                    "replaces both for one kind of quantity (moment,\n"
                                    "angular_velocity, ratio, …) or for a place and\n"
                                    "everything below it (/cases/*/ratio, where * is\n"
                                    "any one key). VALUE is in the unit of A, has a\n"
                                    "unit, or is a percentage. Counts must be equal\n"
                                    "unless named (count=1). May be repeated; the last\n"
                                    "match applies"),
                 "KEY=VALUE");
  rule.expected(1)->take_all()->allow_extra_args(false);
}

void add_form(CLI::App& command, CompareOptions& options) {
  add_choice<StreamFormat>(command,
                           "--format",
                           {{"table", StreamFormat::table}, {"json", StreamFormat::json}},
                           options.format,
                           "format of the differences on standard output");
  add_diagnostics_form(command, options.diagnostics);
  add_flag(
      command,
      "-q,--quiet",
      [&options] { options.is_quiet = true; },
      "print nothing; only the exit status tells");
}

}  // namespace

void add_compare(CLI::App& command, Job& job) {
  const std::string examples =
      "  kinestat compare golden/train.report.json reports/train.report.json\n"
      "  kinestat analyze --format json train.yaml | kinestat compare golden.json -\n"
      "  kinestat compare --rtol 1e-6 --tolerance 'moment=0.5 N*mm' old.json new.json\n"
      "  kinestat compare --tolerance '/cases/*/ratio=0.1%' old.json new.json\n"
      "\nKeys that are not compared, because equal results may differ in them:\n";
  command.footer("");  // not that of the program
  command.footer([examples] {
    std::string text = examples + ignored_keys_help();
    text.pop_back();  // the line end that CLI11 adds
    return text;
  });
  auto reports = std::make_shared<TwoReports>();
  add_reports(command, *reports);
  add_tolerances(command, reports->options.tolerances);
  add_form(command, reports->options);
  run_when_chosen(command, job, [reports] {
    return compare_reports(reports->a, reports->b, reports->options);
  });
}

}  // namespace kinestat::app
