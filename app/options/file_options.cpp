#include "options/file_options.hpp"

#include <charconv>
#include <cstdint>
#include <string_view>

#include "options/sweep_options.hpp"

namespace kinestat::app {

namespace {

// "64M": a whole number of bytes, KiB, MiB or GiB.
std::size_t size_of(const std::string& text) {
  constexpr std::string_view kUnits = "kMG";
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  const std::size_t unit = rest + 1 == end ? kUnits.find(*rest) : std::string_view::npos;
  const bool is_whole = error == std::errc() && (rest == end || unit != std::string_view::npos);
  const std::size_t shift = rest == end ? 0 : 10 * (unit + 1);
  constexpr std::uint64_t kMost = std::uint64_t{1} << 40U;
  if (!is_whole || number == 0 || number > (kMost >> shift)) {
    throw WrongValue("--max-file-size",
                     text,
                     "it is a whole number of bytes or of k, M or G, up to 1024G: 100M");
  }
  return static_cast<std::size_t>(number) << shift;
}

}  // namespace

CLI::Option& with_value(CLI::App& command, CLI::Option* option, const std::string& type) {
  const bool is_choice = type.find('|') != std::string::npos;
  const auto refuse_option =
      [&command, option, is_choice](const std::string& value) -> std::string {
    const bool is_option = value.starts_with("-") &&
                           command.get_option_no_throw(value.substr(0, value.find('='))) != nullptr;
    if (is_option || (value.empty() && !is_choice)) {
      throw MissingValue(option->get_name());
    }
    return {};
  };
  option->check(CLI::Validator(refuse_option, ""));
  return *option->type_name(type);
}

namespace {

CLI::Option& repeated_option(CLI::App& command,
                             const std::string& name,
                             std::vector<std::string>& values,
                             const std::string& description,
                             const std::string& type) {
  CLI::Option& option = with_value(command, command.add_option(name, values, description), type);
  option.expected(1)->take_all()->allow_extra_args(false);
  return option;
}

}  // namespace

void add_repeated(CLI::App& command,
                  const std::string& name,
                  std::vector<std::string>& values,
                  const std::string& description,
                  const std::string& type) {
  repeated_option(command, name, values, description, type);
}

void add_names(CLI::App& command,
               const std::string& name,
               std::vector<std::string>& values,
               const std::string& description,
               const std::string& type) {
  const auto trim = [](std::string& text) {
    CLI::detail::trim(text);
    return std::string();
  };
  repeated_option(command, name, values, description, type)
      .delimiter(',')
      ->transform(CLI::Validator(trim, ""));
}

void add_flag(CLI::App& command,
              const std::string& names,
              std::function<void()> action,
              const std::string& description) {
  command.add_flag_callback(names, std::move(action), description)->disable_flag_override();
}

void add_loading(CLI::App& command, LoadOptions& options) {
  add_repeated(command,
               "--set",
               options.overrides,
               "give a parameter another value; may be repeated",
               "PARAMETER=VALUE");
  const auto take = [&options](const std::string& text) {
    options.limits = ReadLimits::for_size(size_of(text));
  };
  with_value(
      command,
      command.add_option_function<std::string>("--max-file-size",
                                               take,
                                               "allow files larger than 1M, which are usually a\n"
                                               "mistake"),
      "SIZE");
}

void add_curves(CLI::App& command, LoadOptions& options) {
  add_repeated(command,
               "--curve",
               options.curves,
               "take the points of a curve from a CSV file; may be\n"
               "repeated",
               "CURVE=FILE");
}

void add_files(CLI::App& command, FileOptions& options) {
  add_argument(command,
               "FILE",
               options.paths,
               "mechanism files, one after the other; - is\n"
               "standard input")
      .required();
  add_loading(command, options.analyse.load);
  add_diagnostics_form(command, options.analyse.diagnostics);
}

void add_diagnostics_form(CLI::App& command, DiagnosticsForm& form) {
  add_choice<DiagnosticsForm>(command,
                              "--diagnostics",
                              {kDiagnosticsForms.begin(), kDiagnosticsForms.end()},
                              form,
                              "format of errors and warnings on standard error;\n"
                              "json is one line per file, sarif one log for all");
}

void add_format(CLI::App& command, FileOptions& options) {
  add_choice<StreamFormat>(
      command,
      "--format",
      {{"table", StreamFormat::table}, {"json", StreamFormat::json}, {"csv", StreamFormat::csv}},
      options.analyse.format,
      "format of the report on standard output; json of\n"
      "several files is one line per file");
}

void add_layout(CLI::App& command, FileOptions& options) {
  add_choice<TableLayout>(command,
                          "--layout",
                          {{"long", TableLayout::tidy}, {"wide", TableLayout::wide}},
                          options.analyse.output.layout,
                          "layout of CSV: long has one row per value, wide\n"
                          "one per case, point of a duty cycle, or step of a\n"
                          "motion or simulation");
}

void add_fail_fast(CLI::App& command, FileOptions& options) {
  add_flag(
      command,
      "--fail-fast",
      [&options] { options.analyse.fail_fast = true; },
      "stop after the first file that fails");
}

void add_strict(CLI::App& command, FileOptions& options) {
  add_flag(
      command,
      "--strict",
      [&options] { options.analyse.strictness = Strictness::strict; },
      "exit with status 1 if there are warnings");
}

void add_quiet(CLI::App& command, FileOptions& options) {
  add_flag(
      command,
      "-q,--quiet",
      [&options] { options.analyse.is_quiet = true; },
      "print no report on standard output");
}

void add_accuracy(CLI::App& command, AccuracyRequest& request) {
  using enum Accuracy;
  add_choice<Accuracy>(command,
                       "--accuracy",
                       {{"auto", automatic}, {"fast", fast}, {"high", high}, {"exact", exact}},
                       request.accuracy,
                       "how errors are bounded and reduced; see 'kinestat\n"
                       "help accuracy' for the cost");
  add_count(
      command,
      "--digits",
      [&request](std::uint64_t count) {
        if (count > kMostAskedDigits) {
          throw WrongValue(
              "--digits", std::to_string(count), "it is 1 to 15, as values are written as doubles");
        }
        request.digits = static_cast<int>(count);
      },
      "decimal digits that must be correct with\n"
      "--accuracy auto, 1 to 15; default 9");
}

void add_written_file(CLI::App& command, std::string& path, Overwrite& overwrite) {
  const auto standard_output = [](std::string& word) {
    word = word == "-" ? "" : word;
    return std::string();
  };
  add_argument(command, "FILE", path, "the file to write; default: standard output")
      .transform(CLI::Validator(standard_output, ""));
  add_flag(
      command,
      "--force",
      [&overwrite] { overwrite = Overwrite::force; },
      "replace the file if it exists");
}

void add_output(CLI::App& command, AnalyseOptions& analyse, const std::string& explanation) {
  with_value(command, command.add_option("-o,--out", analyse.output.folder, explanation), "FOLDER");
  add_flag(
      command,
      "--force",
      [&analyse] { analyse.output.overwrite = Overwrite::force; },
      "replace files that this program did not write");
}

}  // namespace kinestat::app
