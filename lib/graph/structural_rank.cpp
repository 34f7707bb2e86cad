#include "graph/structural_rank.hpp"

#include <cstddef>
#include <limits>

namespace kinestat {

namespace {

constexpr int kNone = -1;
constexpr int kFar = std::numeric_limits<int>::max();

// Paths from rows without a column lead through pairs to columns without a row; along each, the
// pairs are exchanged. A round takes as many disjoint ones of the shortest length as there are.
class Pairing {
 public:
  Pairing(const EntryPattern& pattern, int column_count)
      : pattern_(pattern),
        column_of_(pattern.size(), kNone),
        row_of_(static_cast<std::size_t>(column_count), kNone) {}

  int size() {
    int pairs = 0;
    while (find_distances()) {
      next_.assign(pattern_.size(), 0);
      for (int row = 0; row < static_cast<int>(pattern_.size()); ++row) {
        pairs += at(column_of_, row) == kNone && extend(row) ? 1 : 0;
      }
    }
    return pairs;
  }

 private:
  static std::size_t place(int i) { return static_cast<std::size_t>(i); }

  static int& at(std::vector<int>& values, int i) { return values[place(i)]; }

  // Of every row from the nearest one without a column, and of the nearest row with a free column;
  // false if there is none.
  bool find_distances() {
    distance_.assign(pattern_.size(), kFar);
    nearest_ = kFar;
    waiting_.clear();
    for (int row = 0; row < static_cast<int>(pattern_.size()); ++row) {
      if (at(column_of_, row) == kNone) {
        at(distance_, row) = 0;
        waiting_.push_back(row);
      }
    }
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      if (at(distance_, waiting_[i]) > nearest_) {
        break;
      }
      look_beyond(waiting_[i]);
    }
    return nearest_ != kFar;
  }

  void look_beyond(int row) {
    for (const int column : pattern_[place(row)]) {
      const int partner = at(row_of_, column);
      if (partner == kNone) {
        nearest_ = at(distance_, row);
      } else if (at(distance_, partner) == kFar) {
        at(distance_, partner) = at(distance_, row) + 1;
        waiting_.push_back(partner);
      }
    }
  }

  // Depth first by growing distance; no entry is tried twice in a round. Paths may be as long as
  // there are rows, so that the way is kept here and not on the stack.
  bool extend(int start) {
    std::vector<int> way = {start};
    while (!way.empty()) {
      const int row = way.back();
      if (next_[place(row)] == pattern_[place(row)].size()) {
        way.pop_back();
        continue;
      }
      const int partner = at(row_of_, pattern_[place(row)][next_[place(row)]++]);
      if (partner == kNone) {
        exchange(way);
        return true;
      }
      const int distance = at(distance_, row) + 1;
      if (distance <= nearest_ && at(distance_, partner) == distance) {
        way.push_back(partner);
      }
    }
    return false;
  }

  // Every row of the way takes the column that it tried last.
  void exchange(const std::vector<int>& way) {
    for (const int row : way) {
      const int column = pattern_[place(row)][next_[place(row)] - 1];
      at(column_of_, row) = column;
      at(row_of_, column) = row;
    }
  }

  const EntryPattern& pattern_;
  std::vector<int> column_of_;
  std::vector<int> row_of_;
  std::vector<int> distance_;
  int nearest_ = kFar;
  std::vector<int> waiting_;
  std::vector<std::size_t> next_;  ///< entry of a row to try
};

}  // namespace

int structural_rank(const EntryPattern& pattern, int column_count) {
  return Pairing(pattern, column_count).size();
}

}  // namespace kinestat
