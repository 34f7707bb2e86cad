#include "studies/sweep/best_rows.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>

namespace kinestat {

namespace {

using Better = bool (*)(const RankedRow&, const RankedRow&);
constexpr Better kBetter = is_better;

// Whether a row keeps another from the front: nowhere worse, and better somewhere or before it.
bool rules_out(const RankedRow& a, const RankKeys& keys, std::uint64_t number) {
  return std::ranges::equal(a.keys, keys, std::greater_equal()) &&
         is_better(a.keys, a.number, keys, number);
}

// What rows have by their second and third key, of which none is nowhere better than another: from
// one to the next the second key rises and the third falls.
class Stairs {
 public:
  // Adds such a pair; false if one is there that is nowhere worse.
  bool add(double second, double third) {
    const auto above = steps_.lower_bound(second);
    if (above != steps_.end() && above->second >= third) {
      return false;
    }
    auto end = steps_.upper_bound(second);
    auto begin = end;
    while (begin != steps_.begin() && std::prev(begin)->second <= third) {
      --begin;
    }
    steps_.erase(begin, end);
    steps_.emplace(second, third);
    return true;
  }

 private:
  std::map<double, double> steps_;
};

}  // namespace

bool TopRows::accepts(const RankKeys& keys, std::uint64_t number) const {
  return rows_.size() < count_ ||
         (count_ > 0 && is_better(keys, number, rows_.front().keys, rows_.front().number));
}

void TopRows::add(RankedRow row) {
  if (!accepts(row.keys, row.number)) {
    return;
  }
  if (rows_.size() == count_) {
    std::ranges::pop_heap(rows_, kBetter);
    rows_.pop_back();
  }
  rows_.push_back(std::move(row));
  std::ranges::push_heap(rows_, kBetter);
}

std::vector<RankedRow> TopRows::take() {
  std::vector<RankedRow> rows = std::exchange(rows_, {});
  std::ranges::sort(rows, kBetter);
  return rows;
}

// Most rows are far from the front, and a few of its rows rule them out.
bool FrontRows::accepts(const RankKeys& keys, std::uint64_t number) {
  const auto ruler = std::ranges::find_if(
      rulers_, [&](const RankedRow& one) { return rules_out(one, keys, number); });
  if (ruler == rulers_.end()) {
    return true;
  }
  std::rotate(rulers_.begin(), ruler, std::next(ruler));
  return false;
}

void FrontRows::add(RankedRow row) {
  constexpr std::size_t kMostRulers = 32;
  if (!accepts(row.keys, row.number)) {
    return;
  }
  if (rulers_.size() == kMostRulers) {
    rulers_.pop_back();
  }
  rulers_.push_back({.keys = row.keys, .number = row.number, .text = {}});
  rows_.push_back(std::move(row));
  if (rows_.size() == most_) {
    reduce();
    most_ = std::max(kFewestRows, 2 * rows_.size());
  }
}

std::vector<RankedRow> FrontRows::take() {
  reduce();
  return std::exchange(rows_, {});
}

// Those that could rule a row out come before it, and are nowhere worse by the first key.
void FrontRows::reduce() {
  std::ranges::sort(rows_, kBetter);
  Stairs stairs;
  std::erase_if(rows_, [&](const RankedRow& row) { return !stairs.add(row.keys[1], row.keys[2]); });
}

BestRows::BestRows(const BestChoice& choice) : rows_(TopRows(choice.count)) {
  if (choice.is_front()) {
    rows_.emplace<FrontRows>();
  }
}

}  // namespace kinestat
