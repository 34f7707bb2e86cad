// The command line: parses it, runs one command, writes its text, returns its status.

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string_view>

#include "command.hpp"
#include "core/version.hpp"

namespace {

using kinestat::ExitStatus;
using kinestat::Outcome;
using kinestat::app::Job;

bool write(std::FILE* stream, std::string_view text) {
  const bool is_written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  return std::fflush(stream) == 0 && is_written;
}

int finish(const Outcome& outcome) {
  ExitStatus status = outcome.status;
  if (!write(stdout, outcome.out)) {
    write(stderr, "kinestat: error[E0152]: standard output cannot be written\n");
    status = kinestat::worst(status, ExitStatus::environment);
  }
  if (!write(stderr, outcome.err)) {
    status = kinestat::worst(status, ExitStatus::environment);
  }
  return static_cast<int>(status);
}

Outcome parse_and_run(int argc, char** argv) {
  CLI::App app("Kinematics, statics and power flow of mechanisms by Davies' method.", "kinestat");
  app.set_version_flag("--version", "kinestat " + std::string(kinestat::kVersion));
  app.require_subcommand(0, 1);
  Job job;
  kinestat::app::add_analyze(app, job);
  kinestat::app::add_check(app, job);
  kinestat::app::add_graph(app, job);
  kinestat::app::add_explain(app, job);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion& call) {
    return {.out = std::string(call.what()) + "\n", .err = {}, .status = ExitStatus::done};
  } catch (const CLI::CallForHelp&) {
    return {.out = app.help(), .err = {}, .status = ExitStatus::done};
  } catch (const CLI::ParseError& problem) {
    return {
        .out = {}, .err = kinestat::app::usage_error(problem, app), .status = ExitStatus::usage};
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
  try {
    return finish(parse_and_run(argc, argv));
  } catch (const std::bad_alloc&) {
    write(stderr, "kinestat: error[E0154]: out of memory\n");
    return static_cast<int>(ExitStatus::environment);
  } catch (const std::exception& bug) {
    write(stderr, "kinestat: internal error: ");
    write(stderr, bug.what());
    write(stderr, "\n");
  }
  return static_cast<int>(ExitStatus::bug);
}
