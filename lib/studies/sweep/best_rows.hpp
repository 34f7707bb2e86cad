// The best rows of a sweep, by one criterion or by several.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "studies/sweep/ranked_row.hpp"

namespace kinestat {

/// Keeps the best of all rows by their first key; its memory does not depend on how many these are.
class TopRows {
 public:
  explicit TopRows(std::size_t count) : count_(count) {}

  bool accepts(const RankKeys& keys, std::uint64_t number) const;
  void add(RankedRow row);
  std::vector<RankedRow> take();

 private:
  std::size_t count_ = 0;
  std::vector<RankedRow> rows_;  ///< a heap, the worst on top
};

/// Keeps the Pareto front of all rows; of rows that are equal by all keys, the first of the sweep.
/// It takes rows that may be of the front and finds out now and then which are: at n log n of the
/// rows it holds, which are at most twice as many as the front has, or a few.
class FrontRows {
 public:
  bool accepts(const RankKeys& keys, std::uint64_t number);
  void add(RankedRow row);
  std::vector<RankedRow> take();

 private:
  static constexpr std::size_t kFewestRows = 1024;

  void reduce();

  std::vector<RankedRow> rows_;
  std::size_t most_ = kFewestRows;  ///< before it reduces them
  /// Rows that have ruled out others, the last one that did in front.
  std::vector<RankedRow> rulers_;
};

/// The rows that a choice keeps of all that it is shown, in whatever order.
class BestRows {
 public:
  explicit BestRows(const BestChoice& choice);

  /// Whether such a row may be kept: its text is needed then.
  bool accepts(const RankKeys& keys, std::uint64_t number) {
    return std::visit([&](auto& rows) { return rows.accepts(keys, number); }, rows_);
  }

  void add(RankedRow row) {
    std::visit([&](auto& rows) { rows.add(std::move(row)); }, rows_);
  }

  /// The best first: by the first criterion, then by the next.
  std::vector<RankedRow> take() {
    return std::visit([](auto& rows) { return rows.take(); }, rows_);
  }

 private:
  std::variant<TopRows, FrontRows> rows_;
};

}  // namespace kinestat
