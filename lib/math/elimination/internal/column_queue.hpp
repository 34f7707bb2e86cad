// Columns in the order in which an elimination takes them.
#pragma once

#include <functional>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

namespace kinestat {

/// Gives the column with the least count; of several the first in the list. A short list is
/// scanned each time; for a long one there is a heap, so that the cost of the whole does not grow
/// with the square of its length.
class ColumnQueue {
 public:
  /// `counts` are those of all columns, and must outlive it.
  ColumnQueue(std::vector<int> columns, std::span<const int> counts);

  /// The count of a column, in the list or not, has changed.
  void tell(int column);

  /// Takes it out of the list; empty after the last.
  std::optional<int> take_least();

 private:
  using Entry = std::pair<int, int>;  // count and place in the list

  bool is_long() const { return !place_.empty(); }

  std::vector<int> columns_;
  std::span<const int> counts_;
  std::vector<int> place_;  ///< of each column in a long list; -1: not in it, or taken
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap_;  ///< old counts among them
};

}  // namespace kinestat
