// Where a word stands on which help has no page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kinestat {

/// Whether the word stands in the text, in any letters, in the plural or not; "dead_point" also as
/// "dead point".
bool mentions(std::string_view text, const std::string& word);

/// A page that may be asked for, and its text.
struct HelpPage {
  std::string command;  ///< "help gears"
  std::string title;
  std::string text;
};

/// The pages that mention the word, each with the first line that has it;
/// then the mechanisms of the library that are called so. Empty if there is none.
std::string mentions_of(const std::string& word, const std::vector<HelpPage>& pages);

}  // namespace kinestat
