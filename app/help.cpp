#include <algorithm>

#include "command.hpp"
#include "run/help_topic.hpp"

namespace kinestat::app {

namespace {

std::vector<std::string> words_of_help(const CLI::App& app) {
  std::vector<std::string> names = {"commands"};
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  return names;
}

// The page of a topic, the help of a command, or that of the program for "commands". A topic may
// have the name of a command, whose own help is that of --help.
Outcome help(const CLI::App& app, const std::string& word) {
  const std::vector<std::string> topics = help_topics();
  if (std::ranges::find(topics, word) != topics.end()) {
    return help_topic(word, {});
  }
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == word) {
      return {.out = command->help(app.get_name()), .err = {}};
    }
  }
  if (word == "commands") {
    return {.out = app.get_formatter()->make_help(&app, app.get_name(), {}), .err = {}};
  }
  return help_topic(word, words_of_help(app));
}

}  // namespace

void add_help(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat help\n"
      "  kinestat help signs\n"
      "  kinestat help reports power\n"
      "  kinestat help analyze\n");
  auto word = std::make_shared<std::string>();
  auto part = std::make_shared<std::string>();
  add_argument(command, "TOPIC", *word, "a topic, or the name of a command; without it, the list");
  add_argument(command, "PART", *part, "of 'reports': the keys of which report, or of what in it");
  command.callback([word, part, &command, &job] {
    job = [word, part, &command] {
      return part->empty() ? help(*command.get_parent(), *word) : help_part(*word, *part);
    };
  });
}

}  // namespace kinestat::app
