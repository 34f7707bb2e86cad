// The best rows of a sweep by one quantity.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace kinestat {

enum class RankOrder { largest, smallest };

/// A row with what decides on its rank. Of equal keys the row that comes first in the sweep wins,
/// so that the choice does not depend on who finds it when.
struct RankedRow {
  double key = 0.0;
  std::uint64_t number = 0;  ///< in the order of the sweep
  std::string text;
};

/// Keeps the best of all rows that it is shown; its memory does not depend on how many these are.
class TopRows {
 public:
  TopRows(std::size_t count, RankOrder order) : count_(count), order_(order) {}

  /// Whether such a row would be kept now.
  bool accepts(double key, std::uint64_t number) const;

  void add(RankedRow row);

  /// The best first.
  std::vector<RankedRow> take();

 private:
  bool is_better(const RankedRow& a, const RankedRow& b) const;

  std::size_t count_ = 0;
  RankOrder order_ = RankOrder::largest;
  std::vector<RankedRow> rows_;  ///< a heap, the worst on top
};

/// Rows as text from which read_rows makes them again, to the last bit of their keys.
std::string write_rows(const std::vector<RankedRow>& rows);

/// What is no such text has no rows.
std::vector<RankedRow> read_rows(const std::string& text);

}  // namespace kinestat
