#include "description/coupling_description.hpp"

#include <array>

namespace kinestat {

namespace {

struct Word {
  CouplingType type;
  std::string_view word;
};

constexpr auto kWords = std::to_array<Word>({{CouplingType::revolute, "revolute"},
                                             {CouplingType::prismatic, "prismatic"},
                                             {CouplingType::gear, "gear"},
                                             {CouplingType::clutch, "clutch"},
                                             {CouplingType::brake, "brake"},
                                             {CouplingType::rigid, "rigid"}});

}  // namespace

std::string_view word_of(CouplingType type) {
  for (const Word& row : kWords) {
    if (row.type == type) {
      return row.word;
    }
  }
  return {};
}

std::optional<CouplingType> find_coupling_type(std::string_view word) {
  for (const Word& row : kWords) {
    if (row.word == word) {
      return row.type;
    }
  }
  return std::nullopt;
}

std::vector<std::string> coupling_type_words() {
  std::vector<std::string> words;
  for (const Word& row : kWords) {
    words.emplace_back(row.word);
  }
  return words;
}

}  // namespace kinestat
