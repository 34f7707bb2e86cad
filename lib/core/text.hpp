// Words for messages: lists of names and the nearest known name.
#pragma once

#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kinestat {

/// "'a', 'b' and 'c'"; at most `limit` names, then "and 4 more". Empty for an empty list.
std::string quoted_list(std::span<const std::string> names, std::size_t limit = 8);

/// "a, b, c"; at most `limit` names, then "and 4 more".
std::string plain_list(std::span<const std::string> names, std::size_t limit = 12);

/// The candidate that a typist most likely meant, or an empty string: edit distance with
/// transpositions at most a third of the word's length (rounded, at least 1), ties to the first.
std::string nearest_name(std::string_view word, std::span<const std::string> candidates);

/// "did you mean 'x'?" or empty, from nearest_name.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

/// The same and what follows it: "did you mean 'x'? its names are x, y"; `rest` alone without one.
std::string guess_before(std::string_view word,
                         std::span<const std::string> candidates,
                         std::string rest);

/// "1 body", "2 bodies".
template <std::integral Number>
std::string counted(Number number, std::string_view one, std::string_view many) {
  return std::to_string(number).append(" ").append(number == 1 ? one : many);
}

/// "1 coupling", "2 couplings".
template <std::integral Number>
std::string counted(Number number, const std::string& noun) {
  return counted(number, noun, noun + "s");
}

/// "0.7 s", "3 min 20 s", "1 h 2 min", "12 d 3 h"
std::string duration_text(double seconds);

}  // namespace kinestat
