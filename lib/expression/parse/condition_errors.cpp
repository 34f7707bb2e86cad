// What the parser says about a text that is no condition.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "expression/parse/condition_parser.hpp"

namespace kinestat {

namespace {

constexpr std::size_t kLongestQuote = 40;  // [bytes]

struct Mistake {
  std::string_view typed;
  std::string_view meant;
};

constexpr auto kMistakes = std::to_array<Mistake>({
    {"=", "== to compare"},
    {"===", "=="},
    {"!==", "!="},
    {"=<", "<="},
    {"=>", ">="},
    {"<>", "!="},
    {"=!", "!="},
    {"!", "not"},
    {"&", "and"},
    {"&&", "and"},
    {"|", "or"},
    {"||", "or"},
});

std::string_view small_word(std::string_view word) {
  constexpr auto kWords = std::to_array<Mistake>(
      {{"AND", "and"}, {"And", "and"}, {"OR", "or"}, {"Or", "or"}, {"NOT", "not"}, {"Not", "not"}});
  const auto* const row = std::ranges::find(kWords, word, &Mistake::typed);
  return row != kWords.end() ? row->meant : std::string_view();
}

}  // namespace

// From a token to before another one.
int ConditionParser::fail(std::size_t first,
                          std::size_t end,
                          std::string message,
                          std::string hint) {
  const int length = end > first ? static_cast<int>(text_between(first, end).size()) : 0;
  error_ = {.offset = tokens_[first].offset,
            .length = length,
            .code = "E0308",
            .message = std::move(message),
            .hint = std::move(hint)};
  return -1;
}

int ConditionParser::fail_operator() {
  const std::size_t end = end_of_operator();
  const std::string_view text = text_between(at_, end);
  const auto* const row = std::ranges::find(kMistakes, text, &Mistake::typed);
  const bool is_known = row != kMistakes.end();
  return fail(at_,
              end,
              fmt::format("'{}' is not allowed in a condition", text),
              is_known ? fmt::format("write {}", row->meant)
                       : std::string("comparisons are == != < <= > >="));
}

// Where a value should begin.
int ConditionParser::fail_missing() {
  if (is_operator(at_) && !find_operator(text_between(at_, end_of_operator()))) {
    return fail_operator();
  }
  if (at_ == 0 && is_symbol(at_, ")")) {
    return fail_leftover();
  }
  if (at_ == 0) {
    const std::size_t end = is_operator(at_) ? end_of_operator() : at_ + 1;
    const std::string_view what = is_operator(at_) ? "value" : "condition";
    return fail(0, end, fmt::format("a {} is missing before '{}'", what, text_between(0, end)));
  }
  std::size_t first = at_ - 1;
  const bool is_after_operator = is_operator(first);
  while (is_after_operator && first > 0 && is_operator(first - 1)) {
    --first;
  }
  const std::string_view what = is_after_operator ? "value" : "condition";
  return fail(
      first, at_, fmt::format("a {} is missing after '{}'", what, text_between(first, at_)));
}

// A value from the token `first` on, which nothing follows that compares it.
int ConditionParser::fail_uncompared(std::size_t first) {
  const std::string_view value = text_between(first, at_);
  return fail(first,
              at_,
              value.size() > kLongestQuote ? std::string("this is a value, not a condition")
                                           : fmt::format("'{}' is a value, not a condition", value),
              "compare it with another one by == != < <= > or >=");
}

// A comparison from `first` on, whose right side begins at `middle`, before another operator.
int ConditionParser::fail_chain(std::size_t first, std::size_t middle) {
  const std::string_view left = text_between(first, at_);
  const std::string_view right = text_between(middle, at_);
  const std::size_t next = at_;
  at_ = end_of_operator();
  at_ = end_of_value();
  const std::string_view rest = text_between(next, at_);
  const bool is_long = left.size() + right.size() + rest.size() > 2 * kLongestQuote;
  return fail(first,
              at_,
              "comparisons cannot be chained",
              is_long ? std::string("join two comparisons with and")
                      : fmt::format("write {} and {} {}", left, right, rest));
}

// A token where a connective or the end should be.
int ConditionParser::fail_leftover() {
  if (is_symbol(at_, ")")) {
    return fail(at_, at_ + 1, "')' closes nothing", "remove it, or write the missing '('");
  }
  const std::string_view text = text_of(token());
  return fail(at_,
              at_ + 1,
              fmt::format("'and' or 'or' is missing before '{}'", text),
              fmt::format("write and {}, or or {}", text, text));
}

// The part that ends here, unless something follows that only values have.
int ConditionParser::fail_if_value(std::size_t first, int part) {
  const bool goes_on = token().kind != TokenKind::end && !is_symbol(at_, ")") &&
                       !is_word(at_, "and") && !is_word(at_, "or");
  return goes_on ? fail(first,
                        at_,
                        fmt::format("'{}' is a condition, not a value", text_between(first, at_)),
                        "join conditions with and, or, not")
                 : part;
}

// A value that cannot be read because its connective is in capitals.
void ConditionParser::hint_at_capitals(std::size_t first) {
  for (std::size_t i = first; i < at_; ++i) {
    const std::string_view word = text_of(tokens_[i]);
    if (const std::string_view small = small_word(word); !small.empty()) {
      fail(i,
           i + 1,
           fmt::format("'{}' is not written in small letters", word),
           fmt::format("write {}", small));
      return;
    }
  }
}

}  // namespace kinestat
