#include "completion_candidates.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>

#include "command.hpp"
#include "core/codes.hpp"
#include "files/file_names.hpp"
#include "help_format.hpp"
#include "run/embedded.hpp"
#include "run/motion.hpp"
#include "run/plot.hpp"
#include "run/texts/help_topic.hpp"
#include "run/texts/library_file.hpp"
#include "run/texts/schema_text.hpp"
#include "run/texts/starter.hpp"
#include "run/texts/written_reports.hpp"

namespace kinestat::app {

namespace {

using Words = std::span<const std::string>;

std::vector<Candidate> without_meaning(const std::vector<std::string>& words) {
  std::vector<Candidate> candidates;
  for (const std::string& word : words) {
    candidates.push_back({.word = word, .meaning = {}});
  }
  return candidates;
}

// The names in the first of the words that is a file.
FileNames names_in(Words words) {
  const auto file = std::ranges::find_if(words, [](const std::string& word) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(word, ignored);
  });
  return file == words.end() ? FileNames{} : names_in_file(*file);
}

std::vector<Candidate> quantity_candidates(Words words) {
  std::vector<std::string> names = motion_words();
  const FileNames of_file = names_in(words);
  names.insert(names.end(), of_file.quantities.begin(), of_file.quantities.end());
  return without_meaning(names);
}

// Names to which a value is given.
std::vector<Candidate> with_equals(std::vector<Candidate> candidates) {
  for (Candidate& one : candidates) {
    one.word += '=';
  }
  return candidates;
}

std::vector<Candidate> parameter_candidates(Words words) {
  return with_equals(without_meaning(names_in(words).parameters));
}

std::vector<Candidate> command_candidates(const CLI::App& app) {
  std::vector<Candidate> candidates;
  for (const CLI::App* command : app.get_subcommands({})) {
    candidates.push_back({.word = command->get_name(), .meaning = command->get_description()});
  }
  return candidates;
}

// Types, keys and codes are hundreds: they follow once a word is begun.
std::vector<Candidate> topic_candidates(const CLI::App& app, Words words) {
  std::vector<Candidate> candidates = without_meaning(help_topics());
  const auto add = [&candidates](const Candidate& one) {
    if (std::ranges::find(candidates, one.word, &Candidate::word) == candidates.end()) {
      candidates.push_back(one);
    }
  };
  std::ranges::for_each(command_candidates(app), add);
  if (!words.back().empty()) {
    for (const HelpWord& one : help_words()) {
      add({.word = one.word, .meaning = one.meaning});
    }
  }
  return candidates;
}

std::vector<Candidate> picture_candidates() {
  std::vector<Candidate> candidates = without_meaning(picture_names());
  candidates.push_back({.word = std::string(kListPictures), .meaning = "all that a file has"});
  return candidates;
}

std::vector<Candidate> code_candidates() {
  std::vector<Candidate> candidates;
  for (const Code& row : all_codes()) {
    candidates.push_back({.word = std::string(row.code), .meaning = std::string(row.title)});
  }
  return candidates;
}

std::vector<Candidate> example_candidates() {
  std::vector<Candidate> candidates;
  for (const LibraryFile& one : library_files()) {
    candidates.push_back({.word = std::string(one.name), .meaning = std::string(one.title)});
  }
  return candidates;
}

// What a value is called in the help says what it may be.
CompletionCandidates values_of(const std::string& called, const CLI::App& app, Words words) {
  if (called.find('|') != std::string::npos) {
    return {.words = without_meaning(CLI::detail::split(called, '|'))};
  }
  for (const char* file : {"FILE", "SHARD", "A", "B"}) {
    if (called == file) {
      return {.words = {}, .paths = PathKind::files};
    }
  }
  if (called == "FOLDER") {
    return {.words = {}, .paths = PathKind::folders};
  }
  if (called == "CURVE=FILE") {
    std::vector<Candidate> curves = with_equals(without_meaning(names_in(words).curves));
    const PathKind paths = curves.empty() ? PathKind::files : PathKind::none;
    return {.words = std::move(curves), .paths = paths};
  }
  const std::pair<const char*, std::function<std::vector<Candidate>()>> kinds[] = {
      {"CASE", [&] { return without_meaning(names_in(words).cases); }},
      {"ACTUATOR", [&] { return without_meaning(names_in(words).actuators); }},
      {"PARAMETER", [&] { return without_meaning(names_in(words).parameters); }},
      {"PARAMETER=VALUE", [&] { return parameter_candidates(words); }},
      {"POSITION", [&] { return without_meaning(names_in(words).positions); }},
      {"QUANTITY", [&] { return quantity_candidates(words); }},
      {"TOPIC", [&] { return topic_candidates(app, words); }},
      {"PICTURE", picture_candidates},
      {"CODE", code_candidates},
      {"PART", [] { return without_meaning(report_pages()); }},
      {"KIND", [] { return without_meaning(starter_kinds()); }},
      {"EXAMPLE", example_candidates},
      {"SCHEMA", [] { return without_meaning(schema_names()); }},
      {"SHELL",
       [] {
         return without_meaning({"bash", "zsh", "fish"});
       }},
  };
  for (const auto& [name, candidates] : kinds) {
    if (called == name) {
      return {.words = candidates()};
    }
  }
  return {};
}

std::vector<Candidate> option_candidates(const CLI::App& command) {
  std::vector<Candidate> candidates;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      std::string meaning =
          option->get_description().substr(0, option->get_description().find(';'));
      std::ranges::replace(meaning, '\n', ' ');
      candidates.push_back({.word = "--" + name, .meaning = std::move(meaning)});
    }
  }
  return candidates;
}

// The option of that name if a value belongs to it.
const CLI::Option* option_with_value(const CLI::App& command, const std::string& name) {
  const CLI::Option* option = name.starts_with('-') ? command.get_option_no_throw(name) : nullptr;
  return option != nullptr && takes_value(*option) ? option : nullptr;
}

// The argument without a name that comes behind the words.
const CLI::Option* next_argument(const CLI::App& command, Words before) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (option_with_value(command, before[i]) != nullptr) {
      ++i;
    } else if (!before[i].starts_with('-')) {
      ++count;
    }
  }
  const CLI::Option* last = nullptr;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) {
      last = option;
      if (count == 0) {
        return option;
      }
      --count;
    }
  }
  const bool is_list =
      last != nullptr && last->get_expected_max() >= CLI::detail::expected_max_vector_size;
  return is_list ? last : nullptr;
}

// Before they are held against what is typed.
CompletionCandidates all_candidates(const CLI::App& app, const CLI::App& command, Words words) {
  const std::string& typed = words.back();
  const Words before = words.first(words.size() - 1);
  if (!before.empty()) {
    if (const CLI::Option* option = option_with_value(command, before.back())) {
      return values_of(option->get_type_name(), app, words);
    }
  }
  if (typed.starts_with('-')) {
    return {.words = option_candidates(command)};
  }
  const CLI::Option* argument = next_argument(command, before);
  return argument == nullptr ? CompletionCandidates{}
                             : values_of(argument->get_name(true), app, words);
}

// "--case=M" is completed as "M" behind "--case", and its candidates begin with "--case=" again.
CompletionCandidates of_command(const CLI::App& app, const CLI::App& command, Words words) {
  const std::string& typed = words.back();
  const std::size_t equals = typed.starts_with("--") ? typed.find('=') : std::string::npos;
  if (equals == std::string::npos) {
    return all_candidates(app, command, words);
  }
  std::vector<std::string> split(words.begin(), words.end() - 1);
  split.push_back(typed.substr(0, equals));
  split.push_back(typed.substr(equals + 1));
  CompletionCandidates candidates = all_candidates(app, command, split);
  for (Candidate& one : candidates.words) {
    one.word.insert(0, typed.substr(0, equals + 1));
  }
  return candidates;
}

}  // namespace

CompletionCandidates completion_candidates(const CLI::App& app, Words words) {
  if (words.empty()) {
    return {.words = command_candidates(app)};
  }
  CompletionCandidates candidates;
  if (words.size() == 1) {
    candidates.words =
        words.front().starts_with('-') ? option_candidates(app) : command_candidates(app);
  } else if (const CLI::App* command = find_command(app, words.front())) {
    candidates = of_command(app, *command, words.subspan(1));
  }
  std::erase_if(candidates.words,
                [&](const Candidate& one) { return !one.word.starts_with(words.back()); });
  return candidates;
}

}  // namespace kinestat::app
