// What to say of a word that no command takes.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace kinestat::app {

struct UsageMessage {
  std::string what;
  std::string hint;
};

/// Unknown commands and options, with the nearest that exists, and words too many. `command` is the
/// one that was being parsed, or the program itself, `app`.
UsageMessage unknown_word(const CLI::App& app, const CLI::App& command, const std::string& word);

/// "'kinestat check --help' shows its use".
std::string help_hint(const CLI::App& command);

/// "did you mean 'x'?" before the rest, or the rest alone.
std::string with_guess(const std::string& guess, const std::string& rest);

}  // namespace kinestat::app
