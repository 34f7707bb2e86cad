// How many states of a sweep were left out, analysed, and with what result.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace kinestat {

/// Of a whole sweep or of a part of it.
struct SweepCounts {
  std::uint64_t states = 0;             ///< all, those left out included
  std::vector<std::uint64_t> excluded;  ///< by each requirement, the first that they violate
  std::uint64_t rows = 0;               ///< one a state and case
  std::vector<std::uint64_t> dropped;   ///< rows, by each condition of 'keep', the first that fails
  std::uint64_t unranked = 0;           ///< of those kept, rows without a value of what ranks them
  std::map<std::string, std::uint64_t, std::less<>> statuses;  ///< rows by status

  /// States that no requirement has excluded.
  std::uint64_t analysed() const;

  /// Rows that fulfil all conditions of 'keep'.
  std::uint64_t kept() const;

  void add(const SweepCounts& other);
};

/// On one line; read_counts gives the same counts back, and nothing for any other text.
std::string write_counts(const SweepCounts& counts);
std::optional<SweepCounts> read_counts(const std::string& text);

}  // namespace kinestat
