#include "words.hpp"

#include <string_view>

#include <fmt/format.h>

namespace kinestat::app {

std::vector<std::string> plain_words(int argc, char** argv) {
  std::vector<std::string> words;
  bool is_after_mark = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--" && !is_after_mark) {
      is_after_mark = true;
      continue;
    }
    if (is_after_mark) {
      words.push_back('\0' + word);
    } else if (word.starts_with("--") && word.ends_with('=')) {
      words.push_back(word.substr(0, word.size() - 1));
      words.emplace_back();
    } else {
      words.push_back(word);
    }
  }
  return words;
}

std::string as_written(const std::string& word) {
  return word.starts_with('\0') ? word.substr(1) : word;
}

DiagnosticsForm diagnostics_form(const std::vector<std::string>& words) {
  constexpr std::string_view kOption = "--diagnostics";
  for (std::size_t i = 0; i < words.size(); ++i) {
    for (const auto& [word, form] : kDiagnosticsForms) {
      const bool follows = words[i] == kOption && i + 1 < words.size() && words[i + 1] == word;
      if (follows || words[i] == fmt::format("{}={}", kOption, word)) {
        return form;
      }
    }
  }
  return DiagnosticsForm::text;
}

}  // namespace kinestat::app
