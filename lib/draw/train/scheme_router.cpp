#include "draw/train/scheme_router.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace kinestat {

namespace {

constexpr double kStep = 1.0;
constexpr double kBend = 4.0;
constexpr double kCrossing = 45.0;

// Right, left, outwards, inwards.
constexpr std::array<GridCell, 4> kMoves = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

bool is_along(std::size_t move) {
  return move < 2;
}

bool has_room(const SchemeRouter& router, GridCell left, bool is_over_shaft) {
  for (int i = 0; i < 4; ++i) {
    if (!router.is_free_within({left.column + i, left.row})) {
      return false;
    }
  }
  for (const int column : {left.column + 1, left.column + 2}) {
    const bool is_free_below =
        left.row == 0 || is_over_shaft || router.is_free_within({column, left.row - 1});
    if (!router.is_free_within({column, left.row + 1}) || !is_free_below) {
      return false;
    }
  }
  return true;
}

}  // namespace

// By cell and the direction in which it was entered.
struct SchemeRouter::Search {
  std::vector<double> price;
  std::vector<int> before;  // the state from which it was reached; -1: from the net itself
};

SchemeRouter::SchemeRouter(int columns, int rows)
    : columns_(columns),
      rows_(rows),
      along_(static_cast<std::size_t>(columns * rows), kFree),
      across_(along_),
      is_tree_(along_.size(), false) {}

void SchemeRouter::block(GridCell cell) {
  along_[index(cell)] = kBlocked;
  across_[index(cell)] = kBlocked;
}

void SchemeRouter::keep(GridCell cell, int net) {
  along_[index(cell)] = net;
  across_[index(cell)] = net;
}

void SchemeRouter::keep_along(GridCell cell, int net) {
  along_[index(cell)] = net;
}

void SchemeRouter::keep_aside(GridCell cell) {
  across_[index(cell)] = kAside;
}

bool SchemeRouter::is_free(GridCell cell) const {
  return along_[index(cell)] == kFree && across_[index(cell)] == kFree;
}

// Dijkstra's search over cells and directions. Prices are whole numbers, and no step costs more
// than there are buckets: what waits for a price stands in one, which is complete once its turn
// comes; states of one price go in their order. The search ends where nothing that is further can
// be the cheapest of the ends; without any it goes everywhere.
SchemeRouter::Search SchemeRouter::search(int net, const std::vector<End>& ends) const {
  constexpr std::size_t kMoveCount = kMoves.size();
  constexpr std::size_t kBuckets = 64;
  constexpr double kNone = std::numeric_limits<double>::infinity();
  static_assert(kStep + kBend + kCrossing < static_cast<double>(kBuckets));
  const std::size_t states = along_.size() * kMoveCount;
  Search result{.price = std::vector<double>(states, kNone),
                .before = std::vector<int>(states, -1)};
  std::vector<double> end_prices(ends.empty() ? 0 : along_.size(), kNone);
  for (const End& end : ends) {
    double& of_cell = end_prices[index(end.cell)];
    of_cell = std::min(of_cell, end.price);
  }
  std::array<std::vector<std::size_t>, kBuckets> waiting;
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < along_.size(); ++cell) {
    const bool is_own = is_tree_[cell] && (along_[cell] == net || across_[cell] == net);
    for (std::size_t d = 0; is_own && d < kMoveCount; ++d) {
      result.price[cell * kMoveCount + d] = 0.0;
      waiting[0].push_back(cell * kMoveCount + d);
      ++count;
    }
  }
  double least_end = kNone;
  for (std::size_t turn = 0; count > 0; ++turn) {
    const auto price = static_cast<double>(turn);
    if (price > least_end) {
      break;
    }
    std::vector<std::size_t>& bucket = waiting[turn % kBuckets];
    std::ranges::sort(bucket);
    count -= bucket.size();
    for (const std::size_t state : bucket) {
      if (price > result.price[state]) {
        continue;
      }
      const std::size_t cell = state / kMoveCount;
      const std::size_t came = state % kMoveCount;
      if (!end_prices.empty()) {
        least_end = std::min(least_end, price + end_prices[cell]);
      }
      const bool can_turn = (along_[cell] == kFree || along_[cell] == net) &&
                            (across_[cell] == kFree || across_[cell] == net);
      const GridCell at = {static_cast<int>(cell) % columns_, static_cast<int>(cell) / columns_};
      for (std::size_t d = 0; d < kMoveCount; ++d) {
        const bool turns = is_along(d) != is_along(came);
        if ((turns && !can_turn) || (!turns && d != came && price > 0)) {
          continue;
        }
        const GridCell to = {at.column + kMoves[d].column, at.row + kMoves[d].row};
        if (to.column < 0 || to.row < 0 || to.column >= columns_ || to.row >= rows_) {
          continue;
        }
        const std::vector<int>& same = is_along(d) ? along_ : across_;
        const std::vector<int>& other = is_along(d) ? across_ : along_;
        const std::size_t next = index(to);
        if ((same[next] != kFree && same[next] != net) || other[next] == kBlocked) {
          continue;
        }
        const bool crosses = other[next] != kFree && other[next] != kAside && other[next] != net;
        const double total =
            price + kStep + (turns && price > 0 ? kBend : 0.0) + (crosses ? kCrossing : 0.0);
        const std::size_t next_state = next * kMoveCount + d;
        if (total < result.price[next_state]) {
          result.price[next_state] = total;
          result.before[next_state] = static_cast<int>(state);
          waiting[static_cast<std::size_t>(total) % kBuckets].push_back(next_state);
          ++count;
        }
      }
    }
    bucket.clear();
  }
  return result;
}

std::vector<double> SchemeRouter::prices(int net) const {
  const Search found = search(net, {});
  std::vector<double> best(along_.size(), std::numeric_limits<double>::infinity());
  for (std::size_t state = 0; state < found.price.size(); ++state) {
    double& cell = best[state / kMoves.size()];
    cell = std::min(cell, found.price[state]);
  }
  return best;
}

std::optional<GridCell> SchemeRouter::connect(int net, const std::vector<End>& ends) {
  if (ends.empty()) {
    return std::nullopt;
  }
  const Search found = search(net, ends);
  double least = std::numeric_limits<double>::infinity();
  int best = -1;
  for (const End& end : ends) {
    for (std::size_t d = 0; d < kMoves.size(); ++d) {
      const std::size_t state = index(end.cell) * kMoves.size() + d;
      if (found.price[state] + end.price < least) {
        least = found.price[state] + end.price;
        best = static_cast<int>(state);
      }
    }
  }
  if (best < 0) {
    return std::nullopt;
  }
  const auto cell_of = [this](std::size_t i) {
    return GridCell{static_cast<int>(i) % columns_, static_cast<int>(i) / columns_};
  };
  price_ += least;
  for (int state = best; state >= 0;) {
    const auto s = static_cast<std::size_t>(state);
    const std::size_t cell = s / kMoves.size();
    const bool along = is_along(s % kMoves.size());
    const int before = found.before[s];
    if (before >= 0) {
      const std::size_t from = static_cast<std::size_t>(before) / kMoves.size();
      steps_.push_back({.from = cell_of(from), .to = cell_of(cell), .net = net});
      std::vector<int>& same = along ? along_ : across_;
      const std::vector<int>& other = along ? across_ : along_;
      crossings_ += other[cell] >= 0 && other[cell] != net ? 1 : 0;
      same[cell] = net;
      same[from] = net;
      is_tree_[cell] = is_tree_[cell] || other[cell] == kFree || other[cell] == net;
      is_tree_[from] = is_tree_[from] || other[from] == kFree || other[from] == net;
    }
    state = before;
  }
  return cell_of(static_cast<std::size_t>(best) / kMoves.size());
}

std::optional<RouterGap> find_gap(const SchemeRouter& router,
                                  int net,
                                  int other,
                                  bool is_over_shaft) {
  const std::vector<double> to_net = router.prices(net);
  const std::vector<double> to_other = router.prices(other);
  double least = std::numeric_limits<double>::infinity();
  RouterGap best;
  for (int row = 0; row < router.rows(); ++row) {
    for (int column = 1; column + 4 < router.columns(); ++column) {
      const std::size_t left = router.index({column, row});
      const std::size_t right = router.index({column + 3, row});
      const double price = std::min(to_net[left] + to_other[right], to_net[right] + to_other[left]);
      if (price < least && has_room(router, {column, row}, is_over_shaft)) {
        least = price;
        best = {.left = {column, row},
                .is_turned = to_net[right] + to_other[left] < to_net[left] + to_other[right]};
      }
    }
  }
  return std::isfinite(least) ? std::optional(best) : std::nullopt;
}

}  // namespace kinestat
