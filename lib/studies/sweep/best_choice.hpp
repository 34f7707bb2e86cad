// Which rows of a sweep are best, where not all are written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kinestat {

enum class RankOrder { largest, smallest };

/// "largest" or "smallest"
std::string_view word_of(RankOrder order);

/// What rows are compared by.
struct Criterion {
  std::string by;  ///< name of a quantity, or a formula of names
  RankOrder order = RankOrder::largest;

  /// "smallest abs(ratio - 4)"
  std::string text() const;
};

/// So many criteria may be weighed against each other.
inline constexpr std::size_t kMostCriteria = 3;

/// By one criterion the best rows; by several, up to kMostCriteria, the rows that no other row
/// equals or beats in all of them: their Pareto front.
struct BestChoice {
  std::uint64_t count = 0;  ///< of the best by one criterion; a front is as long as it is
  std::vector<Criterion> criteria;

  bool is_front() const { return criteria.size() > 1; }
};

/// Reads the criteria of a front: formulas with commas between them, each behind `largest`, which
/// may be left out, or `smallest`. The formulas themselves are not looked at. Empty if these are
/// not two to kMostCriteria.
std::optional<BestChoice> read_front(std::string_view text);

/// Which word is meant where a criterion begins with one that is nearly `largest` or `smallest` and
/// goes on, which no formula does: "did you mean 'smallest'?". Empty if none does.
std::string guess_of_order(std::string_view text);

}  // namespace kinestat
