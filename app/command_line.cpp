#include <algorithm>
#include <map>

#include "command.hpp"
#include "core/text.hpp"

namespace kinestat::app {

namespace {

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  return names;
}

// The sub-command that was being parsed, or the program itself.
const CLI::App& current(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  return chosen.empty() ? app : *chosen.front();
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
    for (const std::string& name : option->get_snames()) {
      names.push_back("-" + name);
    }
  }
  return names;
}

std::string message(const std::string& what, const std::string& hint) {
  return "kinestat: error[E0101]: " + what + "\n  hint: " + hint + "\n";
}

// A value that an option does not take.
class WrongValue : public CLI::ParseError {
 public:
  WrongValue(const std::string& option,
             const std::string& value,
             const std::vector<std::string>& words)
      : CLI::ParseError(
            "WrongValue", option + " cannot be '" + value + "'", CLI::ExitCodes::ValidationError),
        hint_("it is one of " + plain_list(words)) {}

  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

std::string unknown_word(const CLI::App& app) {
  const CLI::App& command = current(app);
  const std::vector<std::string> extras = command.remaining();
  const std::string word = extras.empty() ? std::string() : extras.front();
  if (word.starts_with("-")) {
    const std::string name = word.substr(0, word.find('='));
    const std::string guess = did_you_mean(name, option_names(command));
    return message("unknown option '" + name + "'",
                   guess.empty()
                       ? "'kinestat" + (&command == &app ? "" : " " + command.get_name()) +
                             " --help' lists the options"
                       : guess);
  }
  if (&command != &app) {
    return message("'" + command.get_name() + "' has no use for '" + word + "'",
                   "'kinestat " + command.get_name() + " --help' shows what it takes");
  }
  const std::vector<std::string> names = command_names(app);
  const std::string guess = did_you_mean(word, names);
  return message("unknown command '" + word + "'",
                 (guess.empty() ? "" : guess + " ") + "commands are " + plain_list(names));
}

}  // namespace

void add_files(CLI::App& command, FileOptions& options) {
  command.add_option("FILE", options.paths, "mechanism files; '-' is standard input")
      ->required()
      ->type_name("");
  command
      .add_option(
          "--set", options.analyse.overrides, "gives a parameter another value; may be repeated")
      ->expected(1)
      ->take_all()
      ->type_name("NAME=VALUE");
}

void add_format(CLI::App& command, FileOptions& options) {
  const auto choose = [&options](const std::string& word) {
    const std::map<std::string, StreamFormat> formats = {
        {"table", StreamFormat::table}, {"json", StreamFormat::json}, {"csv", StreamFormat::csv}};
    const auto at = formats.find(word);
    if (at == formats.end()) {
      throw WrongValue("--format", word, {"table", "json", "csv"});
    }
    options.analyse.format = at->second;
  };
  command
      .add_option_function<std::string>(
          "--format", choose, "what to print on standard output: table (default), json or csv")
      ->type_name("FORMAT");
}

void add_strict(CLI::App& command, FileOptions& options) {
  command.add_flag_callback(
      "--strict",
      [&options] { options.analyse.strictness = Strictness::strict; },
      "exit with status 1 if there are warnings");
}

std::string usage_error(const CLI::ParseError& problem, const CLI::App& app) {
  const CLI::App& command = current(app);
  const std::string help =
      "'kinestat" + (&command == &app ? "" : " " + command.get_name()) + " --help' shows its use";
  if (dynamic_cast<const CLI::ExtrasError*>(&problem) != nullptr) {
    return unknown_word(app);
  }
  if (const auto* wrong = dynamic_cast<const WrongValue*>(&problem)) {
    return message(problem.what(), wrong->hint());
  }
  if (dynamic_cast<const CLI::RequiredError*>(&problem) != nullptr) {
    return message(
        &command == &app ? "a command is missing" : "'" + command.get_name() + "' needs a file",
        help);
  }
  // The texts of the parser are sentences such as "--set: 1 required TEXT missing".
  std::string text = problem.what();
  std::ranges::replace(text, '\n', ' ');
  return message(text, help);
}

}  // namespace kinestat::app
