#include "core/spelling.hpp"

#include <algorithm>

namespace kinestat {

std::string in_small_letters(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return result;
}

std::string in_words(std::string_view word) {
  std::string result(word);
  std::ranges::replace(result, '_', ' ');
  return result;
}

std::string hyphenated(std::string_view word) {
  std::string result(word);
  std::ranges::replace(result, '_', '-');
  return result;
}

}  // namespace kinestat
