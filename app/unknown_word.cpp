#include "unknown_word.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "core/utf8.hpp"

namespace kinestat::app {

namespace {

// " check", or nothing for the program itself.
std::string name_of(const CLI::App& command) {
  return command.get_parent() == nullptr ? "" : " " + command.get_name();
}

bool is_file_name(const std::string& word) {
  return word.ends_with(".yaml") || word.ends_with(".yml");
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
    for (const std::string& name : option->get_snames()) {
      names.push_back("-" + name);
    }
  }
  return names;
}

bool has_option(const CLI::App& command, const std::string& option) {
  return std::ranges::count(option_names(command), option) > 0;
}

// The first command that has an option, or null.
const CLI::App* command_with(const CLI::App& app, const std::string& option) {
  const std::vector<const CLI::App*> commands = app.get_subcommands({});
  const auto at = std::ranges::find_if(
      commands, [&option](const CLI::App* command) { return has_option(*command, option); });
  return at == commands.end() ? nullptr : *at;
}

// What to type where an option is of other commands; empty where there is nothing better than
// a guess.
std::string other_way(const CLI::App& command, const std::string& option) {
  if ((option == "-o" || option == "--out") && has_option(command, "--format")) {
    return "the report goes to standard output: add '> FILE'" +
           std::string(has_option(command, "--write-mechanism")
                           ? ", or give --write-mechanism FOLDER for mechanism files"
                           : "");
  }
  return option == "--resume" && has_option(command, "--work")
             ? "the same command with --work FOLDER goes on after an interruption"
             : "";
}

UsageMessage unknown_option(const CLI::App& app, const CLI::App& command, const std::string& word) {
  const std::string name = printable(word.substr(0, word.find('=')));
  if (&command != &app && app.get_option_no_throw(name) != nullptr) {
    return {"option '" + name + "' is of the program, and '" + command.get_name() + "' has none",
            "write 'kinestat " + name + "' alone"};
  }
  const std::string guess = did_you_mean(name, option_names(command));
  const CLI::App* other = &command == &app ? command_with(app, name) : nullptr;
  if (other != nullptr && guess.empty()) {
    return {"option '" + name + "' is before the command",
            "write it after the command, as in 'kinestat" + name_of(*other) + " " + name + "'"};
  }
  if (is_file_name(word)) {
    return {"unknown option '" + printable(word) + "'",
            "write './" + printable(word) + "' for a file of this name"};
  }
  if (const std::string way = other_way(command, name); !way.empty()) {
    return {"unknown option '" + name + "'", way};
  }
  const std::string list = "'kinestat" + name_of(command) + " --help' lists the options";
  return {"unknown option '" + name + "'", guess.empty() ? list : guess};
}

}  // namespace

UsageMessage unknown_word(const CLI::App& app, const CLI::App& command, const std::string& word) {
  if (word.starts_with("-") && word.size() > 1) {
    return unknown_option(app, command, word);
  }
  if (&command != &app) {
    return {"unexpected argument '" + printable(word) + "' of '" + command.get_name() + "'",
            help_hint(command)};
  }
  if (word == "-" || is_file_name(word)) {
    return {"there is no command before the file '" + printable(word) + "'",
            "write 'kinestat analyze " + printable(word) + "'"};
  }
  if (app.get_option_no_throw("--" + word) != nullptr) {
    return {"unknown command '" + printable(word) + "'", "write 'kinestat --" + word + "'"};
  }
  const std::vector<std::string> names = command_names(app);
  return {"unknown command '" + printable(word) + "'",
          with_guess(did_you_mean(word, names), "commands are " + plain_list(names, names.size()))};
}

std::string help_hint(const CLI::App& command) {
  return "'kinestat" + name_of(command) + " --help' shows its use";
}

std::string with_guess(const std::string& guess, const std::string& rest) {
  return guess.empty() ? rest : guess + " " + rest;
}

}  // namespace kinestat::app
