#include "options/sweep_options.hpp"

#include <cerrno>
#include <charconv>
#include <cstdio>

#include "terminal/stop_signals.hpp"

namespace kinestat::app {

void add_count(CLI::App& command,
               const std::string& name,
               std::function<void(std::uint64_t)> take,
               const std::string& description,
               std::uint64_t least) {
  const auto read = [name, least, take = std::move(take)](const std::string& word) {
    std::uint64_t count = 0;
    const char* const end = word.data() + word.size();
    const auto [at, error] = std::from_chars(word.data(), end, count);
    if (error != std::errc() || at != end || count < least) {
      throw WrongValue(name, word, "it is a whole number from " + std::to_string(least));
    }
    take(count);
  };
  with_value(command, command.add_option_function<std::string>(name, read, description), "N");
}

void add_result_folder(CLI::App& command,
                       std::string& folder,
                       Overwrite& overwrite,
                       const std::string& description) {
  with_value(command, command.add_option("-o,--out", folder, description), "FOLDER");
  add_flag(
      command,
      "--force",
      [&overwrite] { overwrite = Overwrite::force; },
      "replace files that this program did not write");
}

ShardNumber read_shard(const std::string& word) {
  std::uint64_t parts[2] = {0, 0};
  const std::size_t slash = word.find('/');
  bool is_good = slash != std::string::npos;
  for (int i = 0; is_good && i < 2; ++i) {
    const std::string part = i == 0 ? word.substr(0, slash) : word.substr(slash + 1);
    is_good = !part.empty() && part.size() <= 6 &&
              part.find_first_not_of("0123456789") == std::string::npos;
    parts[i] = is_good ? std::stoull(part) : 0;
  }
  if (!is_good || parts[0] < 1 || parts[0] > parts[1]) {
    throw WrongValue("--shard", word, "it is K/N, the K-th of N shards: 1/4, 2/4, 3/4 or 4/4");
  }
  return {.number = parts[0], .count = parts[1]};
}

void add_progress(CLI::App& command, ProgressChoice& choice) {
  add_choice<ProgressChoice>(command,
                             "--progress",
                             {{"auto", ProgressChoice::automatic},
                              {"always", ProgressChoice::always},
                              {"never", ProgressChoice::never}},
                             choice,
                             "show progress on standard error; auto: on\na terminal");
}

void add_messages(CLI::App& command, DiagnosticsForm& form, bool& is_quiet) {
  add_diagnostics_form(command, form);
  add_flag(
      command,
      "-q,--quiet",
      [&is_quiet] { is_quiet = true; },
      "do not print the counts on standard error");
}

Outcome run_streaming(const std::function<Outcome(const SweepHooks&)>& job,
                      const std::function<void(const SweepProgress&)>& progress) {
  const StopSignals signals;
  const auto write = [](std::string_view text) {
    const bool is_written =
        std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (!is_written && errno == EPIPE) {
      raise_closed_pipe();
    }
    return is_written;
  };
  Outcome outcome = job({.write = write, .progress = progress, .stop = &signals.flag()});
  if (signals.flag().load()) {
    std::fputs(standard_error(outcome, {}).c_str(), stderr);
    signals.raise_again();
  }
  return outcome;
}

}  // namespace kinestat::app
