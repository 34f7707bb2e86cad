#include <algorithm>

#include <fmt/format.h>

#include "command.hpp"
#include "core/utf8.hpp"
#include "man_page.hpp"
#include "run/texts/help_topic.hpp"

namespace kinestat::app {

namespace {

std::vector<std::string> words_of_help(const CLI::App& app) {
  std::vector<std::string> names = {"commands"};
  for (const CLI::App* command : app.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  return names;
}

bool is_topic(const std::string& word) {
  const std::vector<std::string> topics = help_topics();
  return std::ranges::find(topics, word) != topics.end();
}

// The page of a topic, the help of a command, or that of the program for "commands". A topic may
// have the name of a command, whose own help is that of --help.
Outcome help(const CLI::App& app, const std::string& word) {
  if (is_topic(word)) {
    return help_topic(word, {});
  }
  if (const CLI::App* command = find_command(app, word)) {
    return {.out = command->help(app.get_name()), .err = {}};
  }
  if (word == "commands") {
    return {.out = app.get_formatter()->make_help(&app, app.get_name(), {}), .err = {}};
  }
  return help_topic(word, words_of_help(app));
}

// The same for man(1): of the program, of a command, or of a topic, whose section is 7.
Outcome manual(const CLI::App& app, const std::string& word) {
  const std::string topic = word.ends_with(".7") ? word.substr(0, word.size() - 2) : word;
  if (word.empty()) {
    return {.out = man_page_of_program(app, help_topics()), .err = {}};
  }
  if (const CLI::App* command = find_command(app, word)) {
    return {.out = man_page_of_command(*command, help_topic("exit-status", {}).out), .err = {}};
  }
  return is_topic(topic)
             ? Outcome{.out = man_page_of_topic(topic, help_topic(topic, {}).out), .err = {}}
             : help_topic(word, words_of_help(app));
}

Outcome without_part(const std::string& part) {
  Outcome outcome;
  add_message("E0101",
              fmt::format("there is no page of the manual on the part '{}'", printable(part)),
              "leave --man out, or the part",
              outcome);
  return outcome;
}

struct HelpChoice {
  std::string word;
  std::string part;
  bool is_for_man = false;
};

}  // namespace

void add_help(CLI::App& command, Job& job) {
  command.footer(
      "  kinestat help\n"
      "  kinestat help signs\n"
      "  kinestat help reports power\n"
      "  kinestat help revolute\n"
      "  kinestat help line_of_action\n"
      "  kinestat help E0312\n"
      "  kinestat help analyze\n"
      "  kinestat help --man analyze | man -l -\n");
  auto choice = std::make_shared<HelpChoice>();
  add_argument(command,
               "TOPIC",
               choice->word,
               "a topic, a command, a coupling type, a key of\n"
               "mechanism files or a code; without it, all topics\n"
               "are listed");
  add_argument(command,
               "PART",
               choice->part,
               "after 'reports': show the keys of this report, or\n"
               "of this part");
  add_flag(
      command,
      "--man",
      [choice] { choice->is_for_man = true; },
      "print as a page for man(1); a topic with the name\n"
      "of a command takes the suffix .7: motion.7");
  run_when_chosen(command, job, [choice, &command] {
    const CLI::App& app = *command.get_parent();
    if (!choice->part.empty()) {
      return choice->is_for_man ? without_part(choice->part)
                                : help_part(choice->word, choice->part);
    }
    return choice->is_for_man ? manual(app, choice->word) : help(app, choice->word);
  });
}

}  // namespace kinestat::app
