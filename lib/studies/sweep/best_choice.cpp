#include "studies/sweep/best_choice.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/text.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  return begin == std::string_view::npos
             ? std::string_view()
             : text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

// Up to the next comma that is in no brackets.
std::size_t end_of_formula(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ',' && depth == 0) {
      return i;
    }
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
  }
  return text.size();
}

// Such a word alone is a name.
Criterion criterion_of(std::string_view text) {
  for (const RankOrder order : {RankOrder::largest, RankOrder::smallest}) {
    const std::string_view word = word_of(order);
    const std::string_view rest = text.substr(std::min(word.size(), text.size()));
    if (text.starts_with(word) && !rest.empty() && kBlanks.find(rest.front()) != kBlanks.npos) {
      return {.by = std::string(without_blanks(rest)), .order = order};
    }
  }
  return {.by = std::string(text), .order = RankOrder::largest};
}

}  // namespace

std::string_view word_of(RankOrder order) {
  return order == RankOrder::largest ? "largest" : "smallest";
}

std::string Criterion::text() const {
  return fmt::format("{} {}", word_of(order), by);
}

std::string guess_of_order(std::string_view text) {
  const std::vector<std::string> words = {std::string(word_of(RankOrder::largest)),
                                          std::string(word_of(RankOrder::smallest))};
  for (bool is_through = false; !is_through;) {
    const std::size_t end = end_of_formula(text);
    const std::string_view one = without_blanks(text.substr(0, end));
    const std::string first(one.substr(0, one.find_first_of(kBlanks)));
    const std::string_view rest = without_blanks(one.substr(first.size()));
    const bool goes_on = !rest.empty() && std::string_view("+-*/^<>=!)").find(rest.front()) ==
                                              std::string_view::npos;
    if (goes_on && std::ranges::find(words, first) == words.end()) {
      if (std::string guess = did_you_mean(first, words); !guess.empty()) {
        return guess;
      }
    }
    is_through = end == text.size();
    text.remove_prefix(is_through ? end : end + 1);
  }
  return {};
}

std::optional<BestChoice> read_front(std::string_view text) {
  BestChoice front;
  for (bool is_through = false; !is_through;) {
    const std::size_t end = end_of_formula(text);
    front.criteria.push_back(criterion_of(without_blanks(text.substr(0, end))));
    if (front.criteria.back().by.empty() || front.criteria.size() > kMostCriteria) {
      return std::nullopt;
    }
    is_through = end == text.size();
    text.remove_prefix(is_through ? end : end + 1);
  }
  return front.is_front() ? std::optional(std::move(front)) : std::nullopt;
}

}  // namespace kinestat
