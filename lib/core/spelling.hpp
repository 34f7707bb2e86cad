// How words and numbers are spelled.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace kinestat {

/// ASCII capitals as small letters, all else as it is.
std::string in_small_letters(std::string_view text);

/// A word of reports as one writes it elsewhere: "dead_point" is "dead point".
std::string in_words(std::string_view word);

/// The same of a word that names one thing: "crank_rocker" is a "crank-rocker".
std::string hyphenated(std::string_view word);

/// What the whole of a text is as a number, as std::from_chars reads them; empty if it is none.
template <class Number>
std::optional<Number> number_from(std::string_view text) {
  Number number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

}  // namespace kinestat
