#include "run/help_topic.hpp"

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/utf8.hpp"
#include "run/embedded.hpp"

namespace kinestat {

namespace {

// The first line of a page is "signs: what is positive, and who acts on whom".
std::string_view title_of(const EmbeddedText& page) {
  const std::string_view line = page.text.substr(0, page.text.find('\n'));
  const std::size_t colon = line.find(": ");
  return colon == std::string_view::npos ? line : line.substr(colon + 2);
}

std::string list_of_topics() {
  std::string text = "Topics:\n";
  for (const EmbeddedText& page : embedded_topics()) {
    text += fmt::format("  {:<13} {}\n", page.name, title_of(page));
  }
  return text +
         "\n'kinestat help TOPIC' shows a topic, 'kinestat help COMMAND' the use of a command and\n"
         "'kinestat help commands' lists the commands.\n";
}

}  // namespace

std::vector<std::string> help_topics() {
  return names_of(embedded_topics());
}

Outcome help_topic(const std::string& word, std::span<const std::string> commands) {
  Outcome outcome;
  if (word.empty()) {
    outcome.out = list_of_topics();
    return outcome;
  }
  if (const EmbeddedText* page = find_text(embedded_topics(), word)) {
    outcome.out = page->text;
    return outcome;
  }
  std::vector<std::string> words = help_topics();
  words.insert(words.end(), commands.begin(), commands.end());
  const std::string guess = did_you_mean(word, words);
  add_message("E0101",
              fmt::format("there is no help on '{}'", printable(word)),
              guess.empty()
                  ? fmt::format("topics are {}", plain_list(help_topics(), help_topics().size()))
                  : guess,
              outcome);
  return outcome;
}

}  // namespace kinestat
