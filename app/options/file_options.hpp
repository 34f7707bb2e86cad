// The options that commands on mechanism files share.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "run/analyse.hpp"
#include "usage_error.hpp"
#include "words.hpp"

namespace kinestat::app {

struct FileOptions {
  std::vector<std::string> paths;
  AnalyseOptions analyse;
};

/// What stands for standard output where a file is to be written.
inline constexpr const char* kStandardOutput = "-";

/// Declares --set and --max-file-size.
void add_loading(CLI::App& command, LoadOptions& options);

/// Declares FILE…, --set, --max-file-size and --diagnostics.
void add_files(CLI::App& command, FileOptions& options);

/// --curve, of commands that solve cases.
void add_curves(CLI::App& command, LoadOptions& options);

/// --diagnostics.
void add_diagnostics_form(CLI::App& command, DiagnosticsForm& form);

/// Declares --format.
void add_format(CLI::App& command, FileOptions& options);

/// Declares --layout.
void add_layout(CLI::App& command, FileOptions& options);

/// Declares --fail-fast.
void add_fail_fast(CLI::App& command, FileOptions& options);

/// Declares --strict.
void add_strict(CLI::App& command, FileOptions& options);

/// Declares --quiet.
void add_quiet(CLI::App& command, FileOptions& options);

/// Declares --accuracy and --digits, by which the user trades time for accuracy.
void add_accuracy(CLI::App& command, AccuracyRequest& request);

/// Declares what is written of texts that the program has: FILE, and --force to replace one.
void add_written_file(CLI::App& command, std::string& path, Overwrite& overwrite);

/// Declares -o, explained by this, and --force.
void add_output(CLI::App& command, AnalyseOptions& analyse, const std::string& explanation);

/// Declares an argument without a name, such as FILE.
template <class Value>
CLI::Option& add_argument(CLI::App& command,
                          const std::string& name,
                          Value& value,
                          const std::string& description) {
  const auto write = [](std::string& word) {
    word = as_written(word);
    return std::string();
  };
  return *command.add_option(name, value, description)->transform(CLI::Validator(write, ""));
}

/// Makes an option one that takes a value, described by `type`, which is not another option.
CLI::Option& with_value(CLI::App& command, CLI::Option* option, const std::string& type);

/// Declares an option that may be repeated and takes one value at a time, so that the file behind
/// it is not taken for another.
void add_repeated(CLI::App& command,
                  const std::string& name,
                  std::vector<std::string>& values,
                  const std::string& description,
                  const std::string& type);

/// Likewise one that takes names, which may stand in one value with commas between them.
void add_names(CLI::App& command,
               const std::string& name,
               std::vector<std::string>& values,
               const std::string& description,
               const std::string& type);

/// Declares a flag, which takes no value.
void add_flag(CLI::App& command,
              const std::string& names,
              std::function<void()> action,
              const std::string& description);

/// The words that an option takes, each with what it means.
template <class Choice>
using Choices = std::vector<std::pair<std::string, Choice>>;

template <class Choice>
std::vector<std::string> words_of(const Choices<Choice>& choices) {
  std::vector<std::string> words(choices.size());
  std::ranges::transform(choices, words.begin(), [](const auto& one) { return one.first; });
  return words;
}

/// Declares an option whose value is one of some words.
template <class Choice, class Chosen>
void add_choice(CLI::App& command,
                const std::string& name,
                const Choices<Choice>& choices,
                Chosen& chosen,
                const std::string& description) {
  const auto choose = [name, choices, &chosen](const std::string& word) {
    const auto at = std::ranges::find(choices, word, &Choices<Choice>::value_type::first);
    if (at == choices.end()) {
      throw WrongValue(name, word, words_of(choices));
    }
    chosen = at->second;
  };
  with_value(command,
             command.add_option_function<std::string>(name, choose, description),
             CLI::detail::join(words_of(choices), "|"));
}

}  // namespace kinestat::app
