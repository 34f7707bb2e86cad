#include "usage_error.hpp"

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "unknown_word.hpp"
#include "words.hpp"

namespace kinestat::app {

namespace {

// The sub-command that was being parsed, or the program itself.
const CLI::App& current(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  return chosen.empty() ? app : *chosen.front();
}

// The option that a word of the command line gives, or null.
const CLI::Option* option_of(const CLI::App& command, const std::string& word) {
  return word.starts_with("-") ? command.get_option_no_throw(word.substr(0, word.find('=')))
                               : nullptr;
}

UsageMessage missing_value(const CLI::App& command, const std::string& name) {
  const CLI::Option* option = command.get_option_no_throw(name);
  if (option == nullptr) {
    return {name + " needs a value", help_hint(command)};
  }
  std::string type = option->get_type_name();
  if (type.find('|') == std::string::npos) {
    return {name + " needs a value", "write '" + name + " " + type + "'"};
  }
  return {name + " needs a value",
          "it is one of " + CLI::detail::find_and_replace(type, "|", ", ")};
}

// Too many or too few values: an option given twice, one at the end, a flag with a value.
UsageMessage wrong_number(const CLI::App& command, const std::vector<std::string>& words) {
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional() && option->get_expected_max() == 1 && option->count() > 1 &&
        option->get_multi_option_policy() == CLI::MultiOptionPolicy::Throw) {
      return {option->get_name() + " is given twice", "keep one of the two"};
    }
  }
  for (const std::string& word : words) {
    const CLI::Option* option = option_of(command, word);
    if (option != nullptr && option->get_expected_max() == 0 && word.find('=') != word.npos) {
      return {option->get_name() + " takes no value", "write '" + option->get_name() + "' alone"};
    }
  }
  const CLI::Option* last = words.empty() ? nullptr : option_of(command, words.back());
  return last == nullptr ? UsageMessage{"the command line cannot be understood", help_hint(command)}
                         : missing_value(command, last->get_name());
}

UsageMessage missing_word(const CLI::App& command) {
  return {command.get_parent() == nullptr ? "a command is missing"
                                          : "'" + command.get_name() + "' needs a file",
          help_hint(command)};
}

UsageMessage message_of(const CLI::ParseError& problem,
                        const CLI::App& app,
                        const std::vector<std::string>& words) {
  const CLI::App& command = current(app);
  if (const auto* wrong = dynamic_cast<const WrongValue*>(&problem)) {
    return {problem.what(), wrong->hint()};
  }
  if (const auto* lonely = dynamic_cast<const LonelyOption*>(&problem)) {
    return {problem.what(), lonely->hint()};
  }
  if (const auto* foreign = dynamic_cast<const ForeignOption*>(&problem)) {
    return {problem.what(), foreign->hint()};
  }
  if (dynamic_cast<const MissingValue*>(&problem) != nullptr) {
    return missing_value(command, problem.what());
  }
  // A word that nobody takes is the cause even where a file is missed first.
  for (const CLI::App* one : {&app, &command}) {
    const std::vector<std::string> extras = one->remaining();
    if (!extras.empty()) {
      return unknown_word(app, *one, as_written(extras.front()));
    }
  }
  if (dynamic_cast<const CLI::RequiredError*>(&problem) != nullptr) {
    return missing_word(command);
  }
  return wrong_number(command, words);
}

}  // namespace

WrongValue::WrongValue(const std::string& option,
                       const std::string& value,
                       const std::vector<std::string>& words)
    : CLI::ParseError("WrongValue",
                      option + " cannot be '" + printable(value) + "'",
                      CLI::ExitCodes::ValidationError),
      hint_(with_guess(did_you_mean(value, words), "it is one of " + plain_list(words))) {}

WrongValue::WrongValue(const std::string& option, const std::string& value, std::string hint)
    : CLI::ParseError("WrongValue",
                      option + " cannot be '" + printable(value) + "'",
                      CLI::ExitCodes::ValidationError),
      hint_(std::move(hint)) {}

LonelyOption::LonelyOption(const std::string& option, const std::string& needed, std::string hint)
    : CLI::ParseError("LonelyOption", option + " needs " + needed, CLI::ExitCodes::RequiresError),
      hint_(std::move(hint)) {}

ForeignOption::ForeignOption(const std::string& option, const std::string& other, std::string hint)
    : CLI::ParseError(
          "ForeignOption", option + " does not go with " + other, CLI::ExitCodes::ExcludesError),
      hint_(std::move(hint)) {}

MissingValue::MissingValue(const std::string& option)
    : CLI::ParseError("MissingValue", option, CLI::ExitCodes::ArgumentMismatch) {}

Outcome usage_error(const CLI::ParseError& problem,
                    const CLI::App& app,
                    const std::vector<std::string>& words) {
  const UsageMessage message = message_of(problem, app, words);
  Outcome outcome;
  outcome.form = diagnostics_form(words);
  add_message("E0101", message.what, message.hint, outcome);
  return outcome;
}

}  // namespace kinestat::app
