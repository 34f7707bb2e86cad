#include "studies/sweep/sweep_counts.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/spelling.hpp"

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

// "name=value": the value, if the name is that.
std::optional<std::string_view> value_of(std::string_view word, std::string_view name) {
  return word.starts_with(name) ? std::optional(word.substr(name.size())) : std::nullopt;
}

// Joined by commas; empty for anything else.
std::optional<std::vector<std::uint64_t>> whole_numbers(std::optional<std::string_view> text) {
  std::vector<std::uint64_t> numbers;
  for (const std::string_view one : split(text.value_or("?"), ',')) {
    const auto number = number_from<std::uint64_t>(one);
    if (!number) {
      return std::nullopt;
    }
    numbers.push_back(*number);
  }
  return numbers;
}

void add_each(const std::vector<std::uint64_t>& more, std::vector<std::uint64_t>& sums) {
  sums.resize(std::max(sums.size(), more.size()), 0);
  for (std::size_t i = 0; i < more.size(); ++i) {
    sums[i] += more[i];
  }
}

}  // namespace

std::uint64_t SweepCounts::analysed() const {
  return states - std::accumulate(excluded.begin(), excluded.end(), std::uint64_t{0});
}

std::uint64_t SweepCounts::kept() const {
  return rows - std::accumulate(dropped.begin(), dropped.end(), std::uint64_t{0});
}

void SweepCounts::add(const SweepCounts& other) {
  states += other.states;
  rows += other.rows;
  unranked += other.unranked;
  add_each(other.excluded, excluded);
  add_each(other.dropped, dropped);
  for (const auto& [status, count] : other.statuses) {
    statuses[status] += count;
  }
}

std::string write_counts(const SweepCounts& counts) {
  std::string statuses;
  for (const auto& [status, count] : counts.statuses) {
    statuses += fmt::format("{}{}:{}", statuses.empty() ? "" : ",", status, count);
  }
  return fmt::format("states={} excluded={} rows={} dropped={} unranked={} statuses={}",
                     counts.states,
                     fmt::join(counts.excluded, ","),
                     counts.rows,
                     fmt::join(counts.dropped, ","),
                     counts.unranked,
                     statuses);
}

std::optional<SweepCounts> read_counts(const std::string& text) {
  const std::vector<std::string_view> words = split(text, ' ');
  if (words.size() != 6) {
    return std::nullopt;
  }
  const auto states = value_of(words[0], "states=");
  const auto excluded = value_of(words[1], "excluded=");
  const auto rows = value_of(words[2], "rows=");
  const auto dropped = value_of(words[3], "dropped=");
  const auto unranked = value_of(words[4], "unranked=");
  const auto statuses = value_of(words[5], "statuses=");
  const auto state_count = number_from<std::uint64_t>(states.value_or(""));
  const auto row_count = number_from<std::uint64_t>(rows.value_or(""));
  const auto unranked_count = number_from<std::uint64_t>(unranked.value_or(""));
  const auto excluded_counts = whole_numbers(excluded);
  const auto dropped_counts = whole_numbers(dropped);
  if (!state_count || !excluded_counts || !row_count || !dropped_counts || !unranked_count ||
      !statuses) {
    return std::nullopt;
  }
  SweepCounts counts{.states = *state_count,
                     .excluded = *excluded_counts,
                     .rows = *row_count,
                     .dropped = *dropped_counts,
                     .unranked = *unranked_count,
                     .statuses = {}};
  for (const std::string_view one : split(*statuses, ',')) {
    const std::size_t colon = one.find(':');
    const auto count = colon == std::string_view::npos
                           ? std::nullopt
                           : number_from<std::uint64_t>(one.substr(colon + 1));
    if (!count) {
      return std::nullopt;
    }
    counts.statuses.emplace(one.substr(0, colon), *count);
  }
  return counts;
}

}  // namespace kinestat
