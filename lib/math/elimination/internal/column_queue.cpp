#include "math/elimination/internal/column_queue.hpp"

#include <algorithm>

#include "math/tapes/internal/at.hpp"

namespace kinestat {

namespace {

// Up to this length a scan costs less than a heap.
constexpr std::size_t kLongestScan = 256;

}  // namespace

ColumnQueue::ColumnQueue(std::vector<int> columns, std::span<const int> counts)
    : columns_(std::move(columns)), counts_(counts) {
  if (columns_.size() <= kLongestScan) {
    return;
  }
  place_.assign(counts_.size(), -1);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    at(place_, columns_[i]) = static_cast<int>(i);
    tell(columns_[i]);
  }
}

void ColumnQueue::tell(int column) {
  if (is_long() && at(place_, column) >= 0) {
    heap_.emplace(counts_[static_cast<std::size_t>(column)], at(place_, column));
  }
}

std::optional<int> ColumnQueue::take_least() {
  if (!is_long()) {
    const auto least = std::ranges::min_element(
        columns_, {}, [this](int column) { return counts_[static_cast<std::size_t>(column)]; });
    if (least == columns_.end()) {
      return std::nullopt;
    }
    const int column = *least;
    columns_.erase(least);
    return column;
  }
  while (!heap_.empty()) {
    const auto [count, place] = heap_.top();
    heap_.pop();
    const int column = at(columns_, place);
    if (at(place_, column) >= 0 && counts_[static_cast<std::size_t>(column)] == count) {
      at(place_, column) = -1;
      return column;
    }
  }
  return std::nullopt;
}

}  // namespace kinestat
