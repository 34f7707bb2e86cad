// The command line: parses it, runs one command, writes its text, returns its status.

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string_view>
#include <utility>

#include "command.hpp"
#include "core/version.hpp"
#include "help_format.hpp"
#include "words.hpp"

namespace {

using kinestat::ExitStatus;
using kinestat::Outcome;
using kinestat::app::Job;

bool write(std::FILE* stream, std::string_view text) {
  const bool is_written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  return std::fflush(stream) == 0 && is_written;
}

int finish(Outcome outcome) {
  if (!write(stdout, outcome.out)) {
    kinestat::add_message("E0152", "standard output cannot be written", "", outcome);
  }
  if (!write(stderr, outcome.err)) {
    outcome.status = kinestat::worst(outcome.status, ExitStatus::environment);
  }
  return static_cast<int>(outcome.status);
}

void add_commands(CLI::App& app, Job& job) {
  app.formatter(std::make_shared<kinestat::app::HelpFormat>());
  app.set_version_flag("--version", "kinestat " + std::string(kinestat::kVersion), "the version");
  app.set_help_flag("-h,--help", "this help");
  app.require_subcommand(0, 1);
  app.footer(
      "  kinestat new four-bar crank.yaml\n"
      "  kinestat check crank.yaml\n"
      "  kinestat analyze crank.yaml\n"
      "  kinestat help signs\n");
  kinestat::app::add_new(app, job);
  kinestat::app::add_check(app, job);
  kinestat::app::add_analyze(app, job);
  kinestat::app::add_graph(app, job);
  kinestat::app::add_mobility(app, job);
  kinestat::app::add_inputs(app, job);
  kinestat::app::add_shift(app, job);
  kinestat::app::add_motion(app, job);
  kinestat::app::add_sensitivity(app, job);
  kinestat::app::add_sweep(app, job);
  kinestat::app::add_merge(app, job);
  kinestat::app::add_synthesize(app, job);
  kinestat::app::add_report(app, job);
  kinestat::app::add_compare(app, job);
  kinestat::app::add_bench(app, job);
  kinestat::app::add_plot(app, job);
  kinestat::app::add_explain(app, job);
  kinestat::app::add_schema(app, job);
  kinestat::app::add_help(app, job);
}

Outcome parse_and_run(const std::vector<std::string>& words) {
  CLI::App app("Kinematics, statics and power flow of mechanisms by Davies' method.", "kinestat");
  Job job;
  add_commands(app, job);
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForVersion& call) {
    return {.out = std::string(call.what()) + "\n", .err = {}};
  } catch (const CLI::CallForHelp&) {
    return {.out = app.help(), .err = {}};
  } catch (const CLI::ParseError& problem) {
    return kinestat::app::usage_error(problem, app, words);
  }
  if (!job) {
    return {.out = {}, .err = app.help(), .status = ExitStatus::usage};
  }
  return job();
}

}  // namespace

int main(int argc, char** argv) {
  // A write beyond the file size limit is then an error of that write, with its clean-up.
  std::signal(SIGXFSZ, SIG_IGN);
  const std::vector<std::string> words = kinestat::app::plain_words(argc, argv);
  Outcome failure;
  failure.form = kinestat::app::diagnostics_form(words);
  Outcome out_of_memory = failure;  // Made while there is some.
  kinestat::add_message("E0154", "out of memory", "", out_of_memory);
  try {
    return finish(parse_and_run(words));
  } catch (const std::bad_alloc&) {
    return finish(std::move(out_of_memory));
  } catch (const std::exception& bug) {
    kinestat::add_bug("", bug.what(), failure);
    return finish(std::move(failure));
  }
}
