// Items by counts that change.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "math/tapes/internal/at.hpp"

namespace kinestat {

/// Gives away one with the smallest count, in nearly constant time. An item is filed anew where its
/// count falls; where it has grown, that shows when it is found.
class CountQueue {
 public:
  /// Items 0, 1, … with the count 0.
  explicit CountQueue(int size)
      : count_(static_cast<std::size_t>(size), 0), place_(static_cast<std::size_t>(size), kGone) {}

  void change(int item, int by) {
    at(count_, item) += by;
    if (at(count_, item) < at(place_, item)) {
      file(item);
    }
  }

  int count(int item) const { return at(count_, item); }

  /// From now on the item may be given away, once.
  void add(int item) { file(item); }

  /// Empty if there is none.
  std::optional<int> take() {
    while (lowest_ < static_cast<int>(filed_.size())) {
      std::vector<int>& items = at(filed_, lowest_);
      if (items.empty()) {
        ++lowest_;
        continue;
      }
      const int item = items.back();
      items.pop_back();
      if (at(place_, item) != lowest_) {
        continue;  // given away, or filed anew
      }
      if (at(count_, item) == lowest_) {
        at(place_, item) = kGone;
        return item;
      }
      file(item);
    }
    return std::nullopt;
  }

 private:
  static constexpr int kGone = -1;

  void file(int item) {
    const int count = at(count_, item);
    at(place_, item) = count;
    filed_.resize(std::max(filed_.size(), static_cast<std::size_t>(count) + 1));
    at(filed_, count).push_back(item);
    lowest_ = std::min(lowest_, count);
  }

  std::vector<int> count_;
  std::vector<int> place_;               ///< the count under which an item is filed
  std::vector<std::vector<int>> filed_;  ///< by count; may name items that have gone
  int lowest_ = 0;                       ///< no item is filed under a smaller count
};

}  // namespace kinestat
