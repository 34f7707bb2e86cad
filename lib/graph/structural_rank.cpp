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
      for (std::size_t row = 0; row < pattern_.size(); ++row) {
        if (column_of_[row] == kNone && extend(static_cast<int>(row))) {
          ++pairs;
        }
      }
    }
    return pairs;
  }

 private:
  // Of every row from the nearest one without a column, and of the nearest row with a free column;
  // false if there is none.
  bool find_distances() {
    distance_.assign(pattern_.size(), kFar);
    nearest_ = kFar;
    std::vector<int> waiting;
    for (std::size_t row = 0; row < pattern_.size(); ++row) {
      if (column_of_[row] == kNone) {
        distance_[row] = 0;
        waiting.push_back(static_cast<int>(row));
      }
    }
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      const auto row = static_cast<std::size_t>(waiting[i]);
      if (distance_[row] > nearest_) {
        break;
      }
      for (const int column : pattern_[row]) {
        const int partner = row_of_[static_cast<std::size_t>(column)];
        if (partner == kNone) {
          nearest_ = distance_[row];
        } else if (distance_[static_cast<std::size_t>(partner)] == kFar) {
          distance_[static_cast<std::size_t>(partner)] = distance_[row] + 1;
          waiting.push_back(partner);
        }
      }
    }
    return nearest_ != kFar;
  }

  // Depth first by growing distance; no entry is tried twice in a round. Paths may be as long as
  // there are rows, so that the way is kept here and not on the stack.
  bool extend(int start) {
    std::vector<int> way = {start};
    while (!way.empty()) {
      const auto row = static_cast<std::size_t>(way.back());
      if (next_[row] == pattern_[row].size()) {
        way.pop_back();
        continue;
      }
      const int column = pattern_[row][next_[row]++];
      const int partner = row_of_[static_cast<std::size_t>(column)];
      if (partner == kNone) {
        exchange(way);
        return true;
      }
      const int distance = distance_[row] + 1;
      if (distance <= nearest_ && distance_[static_cast<std::size_t>(partner)] == distance) {
        way.push_back(partner);
      }
    }
    return false;
  }

  // Every row of the way takes the column that it tried last.
  void exchange(const std::vector<int>& way) {
    for (const int row : way) {
      const auto place = static_cast<std::size_t>(row);
      const int column = pattern_[place][next_[place] - 1];
      column_of_[place] = column;
      row_of_[static_cast<std::size_t>(column)] = row;
    }
  }

  const EntryPattern& pattern_;
  std::vector<int> column_of_;
  std::vector<int> row_of_;
  std::vector<int> distance_;
  int nearest_ = kFar;
  std::vector<std::size_t> next_;  ///< entry of a row to try
};

}  // namespace

int structural_rank(const EntryPattern& pattern, int column_count) {
  return Pairing(pattern, column_count).size();
}

}  // namespace kinestat
