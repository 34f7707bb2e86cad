#include "studies/sweep/sweep_counts.hpp"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace kinestat {

namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return parts;
}

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && at == end ? std::optional(value) : std::nullopt;
}

// "name=value": the value, if the name is that.
std::optional<std::string_view> value_of(std::string_view word, std::string_view name) {
  return word.starts_with(name) ? std::optional(word.substr(name.size())) : std::nullopt;
}

}  // namespace

std::uint64_t SweepCounts::analysed() const {
  return states - std::accumulate(excluded.begin(), excluded.end(), std::uint64_t{0});
}

void SweepCounts::add(const SweepCounts& other) {
  states += other.states;
  rows += other.rows;
  excluded.resize(std::max(excluded.size(), other.excluded.size()), 0);
  for (std::size_t i = 0; i < other.excluded.size(); ++i) {
    excluded[i] += other.excluded[i];
  }
  for (const auto& [status, count] : other.statuses) {
    statuses[status] += count;
  }
}

std::string write_counts(const SweepCounts& counts) {
  std::string statuses;
  for (const auto& [status, count] : counts.statuses) {
    statuses += fmt::format("{}{}:{}", statuses.empty() ? "" : ",", status, count);
  }
  return fmt::format("states={} excluded={} rows={} statuses={}",
                     counts.states,
                     fmt::join(counts.excluded, ","),
                     counts.rows,
                     statuses);
}

std::optional<SweepCounts> read_counts(const std::string& text) {
  const std::vector<std::string_view> words = split(text, ' ');
  if (words.size() != 4) {
    return std::nullopt;
  }
  const auto states = value_of(words[0], "states=");
  const auto excluded = value_of(words[1], "excluded=");
  const auto rows = value_of(words[2], "rows=");
  const auto statuses = value_of(words[3], "statuses=");
  const auto state_count = whole_number(states.value_or(""));
  const auto row_count = whole_number(rows.value_or(""));
  if (!state_count || !excluded || !row_count || !statuses) {
    return std::nullopt;
  }
  SweepCounts counts{.states = *state_count, .excluded = {}, .rows = *row_count, .statuses = {}};
  for (const std::string_view one : split(*excluded, ',')) {
    const auto count = whole_number(one);
    if (!count) {
      return std::nullopt;
    }
    counts.excluded.push_back(*count);
  }
  for (const std::string_view one : split(*statuses, ',')) {
    const std::size_t colon = one.find(':');
    const auto count =
        colon == std::string_view::npos ? std::nullopt : whole_number(one.substr(colon + 1));
    if (!count) {
      return std::nullopt;
    }
    counts.statuses.emplace(one.substr(0, colon), *count);
  }
  return counts;
}

}  // namespace kinestat
