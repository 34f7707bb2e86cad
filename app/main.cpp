// The command line: parses it, runs one command, writes its text, returns its status.

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <span>
#include <string_view>
#include <unistd.h>
#include <utility>

#include "command.hpp"
#include "core/version.hpp"
#include "help_format.hpp"
#include "options/file_options.hpp"
#include "terminal/terminal.hpp"
#include "words.hpp"

namespace {

using kinestat::ExitStatus;
using kinestat::Outcome;
using kinestat::app::ColorChoice;
using kinestat::app::Command;
using kinestat::app::Job;
using kinestat::app::kColorChoices;
using kinestat::app::layout_of;

bool write(std::FILE* stream, std::string_view text) {
  const bool is_written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  return std::fflush(stream) == 0 && is_written;
}

int finish(Outcome outcome, ColorChoice color) {
  if (!write(stdout, standard_output(outcome, layout_of(STDOUT_FILENO, color)))) {
    kinestat::add_message("E0152", "standard output cannot be written", "", outcome);
  }
  if (!write(stderr, standard_error(outcome, layout_of(STDERR_FILENO, color)))) {
    outcome.status = kinestat::worst(outcome.status, ExitStatus::environment);
  }
  return static_cast<int>(outcome.status);
}

// The system takes the memory of forms and records sooner than they are taken apart; tools that
// look at the end of a program do so in debug builds.
[[noreturn]] void leave(int status) {
#ifdef NDEBUG
  std::quick_exit(status);
#else
  std::exit(status);
#endif
}

constexpr const char* kVersionFlags = "-V,--version";

// The program with some of its commands, and what its words ask for.
class CommandLine {
 public:
  CommandLine(std::span<const Command> some, ColorChoice& color) {
    app_.formatter(std::make_shared<kinestat::app::HelpFormat>());
    app_.set_version_flag(
        kVersionFlags, "kinestat " + std::string(kinestat::kVersion), "print the version");
    app_.set_help_flag("-h,--help", "print this help");
    app_.require_subcommand(0, 1);
    app_.footer(
        "  kinestat new four-bar crank.yaml\n"
        "  kinestat check crank.yaml\n"
        "  kinestat analyze crank.yaml\n"
        "  kinestat help signs\n");
    for (const Command& command : some) {
      CLI::App& declared =
          *app_.add_subcommand(std::string(command.name), std::string(command.summary));
      command.add_options(declared, job_);
      kinestat::app::add_choice<ColorChoice>(declared,
                                             "--color",
                                             {kColorChoices.begin(), kColorChoices.end()},
                                             color,
                                             "colored text; auto: on a terminal, unless NO_COLOR\n"
                                             "is set");
    }
  }

  Outcome run(const std::vector<std::string>& words) {
    try {
      parse(words);
    } catch (const CLI::CallForVersion& call) {
      return {.out = std::string(call.what()) + "\n", .err = {}};
    } catch (const CLI::CallForHelp&) {
      return {.out = app_.help(), .err = {}};
    } catch (const CLI::ParseError& problem) {
      return kinestat::app::usage_error(problem, app_, words);
    }
    return job_ ? job_() : Outcome{.out = {}, .err = app_.help(), .status = ExitStatus::usage};
  }

  /// What the words ask for, where they are in order and need no more than these commands.
  Job job_of(const std::vector<std::string>& words) {
    try {
      parse(words);
    } catch (const CLI::Error&) {
      return {};
    }
    return job_;
  }

 private:
  void parse(const std::vector<std::string>& words) {
    app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  }

  CLI::App app_{"Kinematics, statics and power flow of mechanisms by Davies' method.", "kinestat"};
  Job job_;
};

// To declare the options of all commands takes longer than to read a small file. So first those of
// the command that is named are, and none for the version; only commands that look at others, and
// messages, do so for all.
Outcome parse_and_run(const std::vector<std::string>& words, ColorChoice& color) {
  const std::span<const Command> all = kinestat::app::commands();
  if (words.size() == 1 && (words.front() == "-V" || words.front() == "--version")) {
    return CommandLine({}, color).run(words);
  }
  const auto named = std::ranges::find_if(all, [&words](const Command& one) {
    return !words.empty() && words.front() == one.name && !one.looks_at_others;
  });
  if (named != all.end()) {
    CommandLine line({named, 1}, color);
    if (const Job job = line.job_of(words)) {
      return job();
    }
  }
  return CommandLine(all, color).run(words);
}

}  // namespace

int main(int argc, char** argv) {
  // A write beyond the file size limit is then an error of that write, with its clean-up.
  std::signal(SIGXFSZ, SIG_IGN);
  const std::vector<std::string> words = kinestat::app::plain_words(argc, argv);
  ColorChoice color = ColorChoice::automatic;
  Outcome failure;
  failure.form = kinestat::app::diagnostics_form(words);
  Outcome out_of_memory = failure;  // Made while there is some.
  kinestat::add_message("E0154", "out of memory", "", out_of_memory);
  try {
    Outcome outcome = parse_and_run(words, color);
    leave(finish(std::move(outcome), color));
  } catch (const std::bad_alloc&) {
    return finish(std::move(out_of_memory), color);
  } catch (const std::exception& bug) {
    kinestat::add_bug("", bug.what(), failure);
    return finish(std::move(failure), color);
  }
}
