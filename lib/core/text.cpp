#include "core/text.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include <fmt/format.h>

#include "core/spelling.hpp"

namespace kinestat {

namespace {

// Damerau-Levenshtein distance (optimal string alignment).
int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t n = b.size() + 1;
  std::vector<int> before(n);
  std::vector<int> last(n);
  std::vector<int> now(n);
  for (std::size_t j = 0; j < n; ++j) {
    last[j] = static_cast<int>(j);
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = static_cast<int>(i);
    for (std::size_t j = 1; j < n; ++j) {
      const int change = a[i - 1] == b[j - 1] ? 0 : 1;
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        now[j] = std::min(now[j], before[j - 2] + 1);
      }
    }
    std::swap(before, last);
    std::swap(last, now);
  }
  return last[n - 1];
}

std::string more(std::size_t left_out) {
  return left_out == 0 ? std::string() : fmt::format(" and {} more", left_out);
}

}  // namespace

std::string quoted_list(std::span<const std::string> names, std::size_t limit) {
  std::string result;
  const std::size_t shown = std::min(names.size(), limit);
  for (std::size_t i = 0; i < shown; ++i) {
    const bool is_last = i + 1 == names.size();
    result += i == 0 ? "" : (is_last ? " and " : ", ");
    result += fmt::format("'{}'", names[i]);
  }
  return result + more(names.size() - shown);
}

std::string plain_list(std::span<const std::string> names, std::size_t limit) {
  const std::size_t shown = std::min(names.size(), limit);
  return fmt::format("{}", fmt::join(names.first(shown), ", ")) + more(names.size() - shown);
}

std::string nearest_name(std::string_view word, std::span<const std::string> candidates) {
  constexpr std::size_t kLongestWord = 64;
  if (word.size() > kLongestWord) {
    return {};
  }
  int best = std::max(1, (static_cast<int>(word.size()) + 1) / 3) + 1;
  std::string nearest;
  for (const std::string& candidate : candidates) {
    if (candidate.size() > kLongestWord) {
      continue;
    }
    const int distance =
        in_small_letters(word) == in_small_letters(candidate) ? 0 : edit_distance(word, candidate);
    if (distance < best && distance < static_cast<int>(word.size())) {
      best = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
  const std::string nearest = nearest_name(word, candidates);
  return nearest.empty() ? std::string() : fmt::format("did you mean '{}'?", nearest);
}

std::string guess_before(std::string_view word,
                         std::span<const std::string> candidates,
                         std::string rest) {
  const std::string guess = did_you_mean(word, candidates);
  return guess.empty() ? rest : fmt::format("{} {}", guess, rest);
}

std::string duration_text(double seconds) {
  struct Unit {
    std::string_view name;
    std::int64_t seconds;
  };

  constexpr Unit kUnits[] = {{"d", 86400}, {"h", 3600}, {"min", 60}, {"s", 1}};
  const auto whole = static_cast<std::int64_t>(std::clamp(seconds, 0.0, 1e15) + 0.5);
  for (std::size_t i = 0; i + 1 < std::size(kUnits); ++i) {
    const Unit& unit = kUnits[i];
    const Unit& next = kUnits[i + 1];
    if (whole >= unit.seconds) {
      return fmt::format("{} {} {} {}",
                         whole / unit.seconds,
                         unit.name,
                         whole % unit.seconds / next.seconds,
                         next.name);
    }
  }
  constexpr double kFew = 9.95;  // seconds: above it, none is cut
  return seconds < kFew ? fmt::format("{:.2g} s", seconds) : fmt::format("{} s", whole);
}

}  // namespace kinestat
