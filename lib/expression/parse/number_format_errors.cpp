#include "expression/parse/number_format_errors.hpp"

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/spelling.hpp"
#include "expression/parse/characters.hpp"

namespace kinestat {

namespace {

// Everything that looks as if it belonged to a number: 0x1F, 1_000, 12:30, 1.2.3.
std::size_t end_of_lookalike(std::string_view text, std::size_t at) {
  while (at < text.size() && (is_name_part(text[at]) || has(text, at, ".:"))) {
    ++at;
  }
  return at;
}

std::string without_leading_zeros(std::string_view text) {
  const std::size_t first = text.find_first_not_of('0');
  const bool needs_zero = first == std::string_view::npos || text[first] == '.';
  return (needs_zero ? "0" : "") + std::string(text.substr(std::min(first, text.size())));
}

ExpressionError number_error(std::size_t begin,
                             std::size_t end,
                             std::string message,
                             std::string hint) {
  return {.offset = static_cast<int>(begin),
          .length = static_cast<int>(end - begin),
          .code = "E0308",
          .message = std::move(message),
          .hint = std::move(hint)};
}

// "write 31" for 0x1F, if that is a number.
std::string hint_for_base(std::string_view word) {
  const char letter = in_small_letters(word)[1];
  const int base = letter == 'x' ? 16 : letter == 'o' ? 8 : 2;
  unsigned long long value = 0;
  const char* const last = word.data() + word.size();
  const auto [end, fault] = std::from_chars(word.data() + 2, last, value, base);
  const bool is_number = fault == std::errc() && end == last;
  return is_number ? fmt::format("write {}", value) : "write a decimal, with the digits 0-9";
}

// Where a number begins whose digits after a decimal comma begin at `at`; `at` if there is none.
std::size_t begin_of_decimal_comma(std::string_view text, std::size_t at) {
  if (at < 2 || text[at - 1] != ',' || !is_digit(text[at - 2])) {
    return at;
  }
  std::size_t begin = at - 1;
  while (begin > 0 && (is_digit(text[begin - 1]) || text[begin - 1] == '.')) {
    --begin;
  }
  return begin;
}

// Where groups of a comma and three digits from `at` on end, and a fraction behind them; `at` if
// there are none.
std::size_t end_of_groups(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (has(text, end, ",") && skip_digits(text, end + 1) == end + 4) {
    end += 4;
  }
  return end > at && has(text, end, ".") ? skip_digits(text, end + 1) : end;
}

// The number as one reads it whose commas group its digits: 1000.5 for 1,000.5. Empty if they do
// not, and for one comma alone, which may be either.
std::string grouped_number(std::string_view number) {
  const std::size_t comma = number.find(',');
  const bool is_grouped = comma == skip_digits(number, 0) && comma > 0 && comma <= 3 &&
                          end_of_groups(number, comma) == number.size();
  const std::string plain = without(number, ',');
  const bool is_clear = plain.size() + 1 < number.size() || plain.find('.') != std::string::npos;
  return is_grouped && is_clear ? plain : std::string();
}

ExpressionError leading_zero(std::string_view text, std::size_t begin, std::size_t end) {
  if (const std::size_t first = begin_of_decimal_comma(text, begin); first < begin) {
    return decimal_comma(text, static_cast<int>(first), static_cast<int>(end));
  }
  const std::string_view number = text.substr(begin, end - begin);
  return number_error(begin,
                      end,
                      fmt::format("'{}' begins with a zero", number),
                      fmt::format("write {}", without_leading_zeros(number)));
}

}  // namespace

std::optional<ExpressionError> find_foreign_number(std::string_view text,
                                                   std::size_t begin,
                                                   std::size_t end) {
  const std::size_t wide = end_of_lookalike(text, begin);
  const std::string_view word = text.substr(begin, wide - begin);
  if (text[begin] == '0' && has(text, begin + 1, "xXbBoO")) {
    return number_error(
        begin, wide, fmt::format("'{}' is not a decimal", word), hint_for_base(word));
  }
  if (has(text, end, "_")) {
    return number_error(begin,
                        wide,
                        fmt::format("'{}' groups its digits", word),
                        fmt::format("write {}", without(word, '_')));
  }
  if (has(text, end, ":")) {
    return number_error(begin,
                        wide,
                        fmt::format("'{}' looks like a time of day", word),
                        "write one decimal with its unit, such as 12.5 min; for a ratio write /");
  }
  if (has(text, end, ".") && has_digit(text, end + 1)) {
    return number_error(begin,
                        wide,
                        fmt::format("'{}' has more than one decimal point", word),
                        "write a number as 1234.5");
  }
  return text[begin] == '0' && has_digit(text, begin + 1)
             ? std::optional(leading_zero(text, begin, end))
             : std::nullopt;
}

std::optional<ExpressionError> find_spaced_number(std::string_view text,
                                                  int begin,
                                                  std::size_t at) {
  const auto first = static_cast<std::size_t>(begin);
  const std::size_t middle = skip_digits(text, first);
  const std::size_t end = skip_digits(text, at);
  const bool is_blank_between =
      std::ranges::all_of(text.substr(middle, at - middle), [](char c) { return is_space(c); });
  if (!is_blank_between || end != at + 3) {
    return std::nullopt;
  }
  return number_error(first,
                      end,
                      fmt::format("'{}' is two numbers", text.substr(first, end - first)),
                      fmt::format("write {}{}, or an operator between them",
                                  text.substr(first, middle - first),
                                  text.substr(at, end - at)));
}

ExpressionError decimal_comma(std::string_view text, int begin, int end) {
  const auto first = static_cast<std::size_t>(begin);
  const std::size_t comma = text.find(',', first);
  const std::size_t last = std::max(static_cast<std::size_t>(end), end_of_groups(text, comma));
  const std::string_view number = text.substr(first, last - first);
  if (const std::string plain = grouped_number(number); !plain.empty()) {
    return number_error(
        first, last, fmt::format("'{}' groups its digits", number), fmt::format("write {}", plain));
  }
  const std::string_view left = text.substr(first, comma - first);
  const std::string_view right = text.substr(comma + 1, last - comma - 1);
  const bool may_group = right.size() == 3 && left.find('.') == std::string_view::npos;
  return number_error(first,
                      last,
                      fmt::format("'{}' has a decimal comma", number),
                      may_group ? fmt::format("write {0}.{1}, or {0}{1} for thousands", left, right)
                                : fmt::format("write {}.{}", without(left, '.'), right));
}

ExpressionError number_out_of_range(std::string_view text,
                                    std::size_t begin,
                                    std::size_t end,
                                    bool is_tiny) {
  return number_error(
      begin,
      end,
      fmt::format("'{}' is {}",
                  text.substr(begin, end - begin),
                  is_tiny ? "too small (underflow)" : "out of range"),
      is_tiny ? "write 0, or choose a smaller unit" : "numbers reach to about 1.8e308");
}

ExpressionError not_finite(std::string_view text, std::size_t begin, std::size_t end) {
  return number_error(begin,
                      end,
                      fmt::format("'{}' is not a finite number", text.substr(begin, end - begin)),
                      "write a finite number");
}

}  // namespace kinestat
