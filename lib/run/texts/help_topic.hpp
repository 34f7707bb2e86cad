// Pages of help on what is common to all commands: the format, signs, reports and so on.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "files/outcome.hpp"

namespace kinestat {

/// "format", "signs" and so on.
std::vector<std::string> help_topics();

/// A word that help explains, and what it is; empty of a key.
struct HelpWord {
  std::string word;
  std::string meaning = {};
};

/// Those that are no topics: types of couplings, keys of the format and codes, each word once.
std::vector<HelpWord> help_words();

/// The page of a topic, of a type of coupling, of a key of the format or of a code; without a word,
/// the list of topics. `commands` are the other words that could be meant.
Outcome help_topic(const std::string& word, std::span<const std::string> commands);

/// The page of a part of a topic, of which "reports" alone has some.
Outcome help_part(const std::string& topic, const std::string& part);

}  // namespace kinestat
