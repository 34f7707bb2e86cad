#include "run/texts/help_topic.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/codes.hpp"
#include "core/contract.hpp"
#include "core/page_text.hpp"
#include "core/text.hpp"
#include "core/utf8.hpp"
#include "couplings/kinds.hpp"
#include "expression/units.hpp"
#include "format/key_table.hpp"
#include "io/synonyms.hpp"
#include "run/embedded.hpp"
#include "run/texts/explain.hpp"
#include "run/texts/word_mentions.hpp"
#include "run/texts/written_reports.hpp"
#include "studies/compare/compare_values.hpp"
#include "studies/simulation/task/simulation_limits.hpp"

namespace kinestat {

namespace {

// The first line of a page is "signs: what is positive, and who acts on whom".
std::string_view title_of(const EmbeddedText& page) {
  const std::string_view line = page.text.substr(0, page.text.find('\n'));
  const std::size_t colon = line.find(": ");
  return colon == std::string_view::npos ? line : line.substr(colon + 2);
}

// The page in which a line "{{keys SECTION}}" stands for the keys of the section, else that of its
// name.
std::string page_of(std::string_view section) {
  const std::string line = fmt::format("{{{{keys {}}}}}\n", section);
  for (const EmbeddedText& page : embedded_topics()) {
    if (page.text.find(line) != std::string_view::npos) {
      return std::string(page.name);
    }
  }
  const EmbeddedText* same = find_text(embedded_topics(), section);
  return same != nullptr ? std::string(same->name) : std::string();
}

std::string list_of_units() {
  return page_lines("", fmt::format("{}", fmt::join(unit_names(), " ")), 4);
}

// A line between braces in the page, as what it stands for.
std::string table_of(std::string_view line, const EmbeddedText& page) {
  constexpr std::string_view kKeys = "{{keys ";
  if (line.starts_with(kKeys)) {
    return key_table(line.substr(kKeys.size(), line.find('}') - kKeys.size()));
  }
  if (line == "{{units}}") {
    return list_of_units();
  }
  if (line == "{{not simulated}}") {
    return page_lines("", simulation_limits() + ".", 4);
  }
  if (line == "{{types}}") {
    return coupling_table();
  }
  if (line == "{{action directions}}") {
    return action_directions();
  }
  if (line == "{{sliding types}}") {
    return sliding_kinds();
  }
  if (line == "{{report}}") {
    return report_keys();
  }
  if (line == "{{kinds}}") {
    return page_lines("", plain_list(value_kinds(), value_kinds().size()), 4);
  }
  if (line == "{{reports}}") {
    return page_lines("", plain_list(report_pages(), report_pages().size()), 4);
  }
  KINESTAT_EXPECTS(line == "{{sections}}");
  return section_table([&](std::string_view section) {
    const std::string other = page_of(section);
    return other == page.name ? std::string() : other;
  });
}

std::string filled(const EmbeddedText& page) {
  std::string text;
  for (std::string_view rest = page.text; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    text += line.starts_with("{{") ? table_of(line, page) : fmt::format("{}\n", line);
  }
  return text;
}

std::string list_of_topics() {
  std::string text = "Topics:\n";
  for (const EmbeddedText& page : embedded_topics()) {
    text += page_lines(fmt::format("  {:<13} ", page.name), title_of(page), 16);
  }
  return text +
         "\n'kinestat help TOPIC' shows a topic, 'kinestat help COMMAND' the use of a\n"
         "command and 'kinestat help commands' lists the commands. It also explains a\n"
         "type of coupling, a key of mechanism files, and a code: 'kinestat help\n"
         "revolute', 'kinestat help line_of_action', 'kinestat help E0312'.\n";
}

template <class Is>
const CouplingKind* find_kind(const Is& is) {
  const auto kinds = coupling_kinds();
  const auto at = std::ranges::find_if(kinds, [&](const CouplingKind* kind) { return is(*kind); });
  return at == kinds.end() ? nullptr : *at;
}

std::string page_of_kind(const CouplingKind* kind) {
  if (kind == nullptr) {
    return {};
  }
  const EmbeddedText* example = find_text(embedded_couplings(), kind->word);
  return coupling_page(*kind, example != nullptr ? example->text : std::string_view());
}

bool is_of_term(std::string_view word, std::string_view terms) {
  while (!terms.empty()) {
    const std::string_view one = terms.substr(0, terms.find(", "));
    if (one == word) {
      return true;
    }
    terms.remove_prefix(std::min(terms.size(), one.size() + 2));
  }
  return false;
}

// The lines of the glossary on a term: two spaces, the term or several with commas, more spaces,
// and what it means, in lines that are indented further. Empty of what is none.
std::string glossary_lines(const std::string& word) {
  constexpr std::string_view kIndent = "  ";
  const EmbeddedText* const page = find_text(embedded_topics(), "glossary");
  KINESTAT_EXPECTS(page != nullptr);
  std::string term = word;
  std::ranges::replace(term, '_', ' ');
  std::string lines;
  for (std::string_view rest = page->text; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == kIndent.size()) {
      if (!lines.empty()) {
        break;
      }
      const std::string_view from_term = line.substr(begin);
      lines = is_of_term(term, from_term.substr(0, from_term.find(kIndent)))
                  ? fmt::format("{}\n", line)
                  : "";
    } else if (begin > kIndent.size() && begin != line.npos && !lines.empty()) {
      lines += fmt::format("{}\n", line);
    } else if (!lines.empty()) {
      break;
    }
  }
  return lines;
}

// Topics in which the word stands, but for the glossary, which has lines on all of them.
std::vector<std::string> topics_with(const std::string& word) {
  std::vector<std::string> topics;
  for (const EmbeddedText& page : embedded_topics()) {
    if (page.name != "glossary" && mentions(page.text, word)) {
      topics.emplace_back(page.name);
    }
  }
  return topics;
}

std::string glossary_page(const std::string& word) {
  std::string text = glossary_lines(word);
  if (!text.empty()) {
    const std::vector<std::string> topics = topics_with(word);
    text += topics.empty()
                ? "\n'kinestat help glossary' has the other terms.\n"
                : page_lines(
                      "\nMore with 'kinestat help TOPIC': ", plain_list(topics, topics.size()), 2);
  }
  return text;
}

// Of what is no topic: a type of coupling, a key, what a type is called elsewhere, a term of the
// glossary, or a code.
Outcome word_page(const std::string& word) {
  const auto is_it = [&](const CouplingKind& kind) { return kind.word == word; };
  const auto is_also_it = [&](const CouplingKind& kind) {
    return std::ranges::find(kind.others, word) != kind.others.end();
  };
  Outcome outcome;
  const std::string term = glossary_lines(word);
  outcome.out = page_of_kind(find_kind(is_it));
  if (outcome.out.empty()) {
    outcome.out = key_page(word, [](std::string_view section) { return page_of(section); });
  }
  if (outcome.out.empty()) {
    outcome.out = page_of_kind(find_kind(is_also_it));
  }
  if (!outcome.out.empty() && !term.empty()) {
    outcome.out = fmt::format("{}\n{}", term, outcome.out);
  }
  if (outcome.out.empty()) {
    outcome.out = glossary_page(word);
  }
  return outcome.out.empty() && is_code(word) ? explain(word) : outcome;
}

// All that is no key: keys stand in the pages of their sections.
std::vector<HelpPage> help_pages() {
  std::vector<HelpPage> pages;
  for (const EmbeddedText& page : embedded_topics()) {
    pages.push_back({.command = fmt::format("help {}", page.name),
                     .title = std::string(title_of(page)),
                     .text = filled(page)});
  }
  for (const CouplingKind* kind : coupling_kinds()) {
    pages.push_back({.command = fmt::format("help {}", kind->word),
                     .title = std::string(kind->meaning),
                     .text = fmt::format("{}", fmt::join(kind->others, ", "))});
  }
  return pages;
}

// A topic, a type, a key or a term by its plural or without it.
Outcome page_in_other_number(const std::string& word) {
  const std::string other =
      word.ends_with('s') ? word.substr(0, word.size() - 1) : fmt::format("{}s", word);
  if (const EmbeddedText* page = find_text(embedded_topics(), other)) {
    Outcome outcome;
    outcome.out = filled(*page);
    return outcome;
  }
  return word_page(other);
}

std::vector<std::string> all_words(std::span<const std::string> commands) {
  std::vector<std::string> words = help_topics();
  words.insert(words.end(), commands.begin(), commands.end());
  for (const CouplingKind* kind : coupling_kinds()) {
    words.emplace_back(kind->word);
  }
  const std::vector<std::string> keys = format_keys();
  words.insert(words.end(), keys.begin(), keys.end());
  return words;
}

// Empty where the word stands nowhere. It is no slip then, unless it is nearly a command.
Outcome mentions_page(const std::string& word,
                      std::span<const std::string> commands,
                      std::span<const std::string> words) {
  Outcome outcome;
  const std::string text = mentions_of(word, help_pages());
  if (text.empty()) {
    return outcome;
  }
  const std::string meant = meant_name(word, words);
  const bool is_synonym = meant != nearest_name(word, words);
  const std::string slip = did_you_mean(word, commands);
  outcome.out = fmt::format("no page on '{}'; {} is mentioned in:\n\n{}{}",
                            printable(word),
                            is_synonym ? fmt::format("did you mean '{}'? It", meant) : "it",
                            text,
                            slip.empty() ? "" : fmt::format("\nOr {}\n", slip));
  return outcome;
}

}  // namespace

std::vector<std::string> help_topics() {
  return names_of(embedded_topics());
}

std::vector<HelpWord> help_words() {
  std::vector<HelpWord> words;
  for (const CouplingKind* kind : coupling_kinds()) {
    words.push_back({.word = std::string(kind->word), .meaning = std::string(kind->meaning)});
  }
  for (std::string& key : format_keys()) {
    if (std::ranges::find(words, key, &HelpWord::word) == words.end()) {
      words.push_back({.word = std::move(key)});
    }
  }
  for (const Code& row : all_codes()) {
    words.push_back({.word = std::string(row.code), .meaning = std::string(row.title)});
  }
  return words;
}

Outcome help_topic(const std::string& word, std::span<const std::string> commands) {
  Outcome outcome;
  if (word.empty()) {
    outcome.out = list_of_topics();
    return outcome;
  }
  if (const EmbeddedText* page = find_text(embedded_topics(), word)) {
    outcome.out = filled(*page);
    return outcome;
  }
  if (Outcome page = word_page(word); !page.out.empty() || !page.err.plain().empty()) {
    return page;
  }
  if (Outcome page = page_in_other_number(word); !page.out.empty()) {
    return page;
  }
  const std::vector<std::string> words = all_words(commands);
  if (Outcome page = mentions_page(word, commands, words); !page.out.empty()) {
    return page;
  }
  const std::string guess = did_you_mean_word(word, words);
  const std::vector<std::string> all = help_topics();
  add_message("E0101",
              fmt::format("there is no help on '{}'", printable(word)),
              guess.empty() ? fmt::format("topics are {}", plain_list(all, all.size())) : guess,
              outcome);
  return outcome;
}

Outcome help_part(const std::string& topic, const std::string& part) {
  constexpr std::string_view kTopic = "reports";
  Outcome outcome;
  outcome = topic == kTopic ? Outcome() : word_page(fmt::format("{}_{}", topic, part));
  outcome.out = topic == kTopic ? report_page(part) : outcome.out;
  if (!outcome.out.empty()) {
    return outcome;
  }
  const std::vector<std::string> parts = report_pages();
  const std::string guess = did_you_mean(part, parts);
  add_message(
      "E0101",
      fmt::format("there is no help on '{} {}'", printable(topic), printable(part)),
      topic != kTopic
          ? fmt::format("only '{}' has parts, as in 'kinestat help {} power'", kTopic, kTopic)
      : guess.empty() ? fmt::format("parts of '{}' are {}", kTopic, plain_list(parts, parts.size()))
                      : guess,
      outcome);
  return outcome;
}

}  // namespace kinestat
