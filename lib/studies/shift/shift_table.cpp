#include "studies/shift/shift_table.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/tolerance.hpp"

namespace kinestat {

namespace {

// Forward gears, reverse gears, gears without a ratio.
int group_of(const TableGear& gear, double forward) {
  if (!gear.ratio) {
    return 2;
  }
  return *gear.ratio * forward > 0.0 ? 0 : 1;
}

bool is_same(const TableGear& a, const TableGear& b) {
  return a.ratio && b.ratio &&
         std::abs(*a.ratio - *b.ratio) <=
             kSameValue * std::max(std::abs(*a.ratio), std::abs(*b.ratio));
}

// The forward gear before it that has another ratio.
std::optional<double> step_of(std::span<const TableGear> gears, double forward, std::size_t i) {
  if (group_of(gears[i], forward) != 0) {
    return std::nullopt;
  }
  for (std::size_t j = i; j-- > 0;) {
    if (!is_same(gears[j], gears[i])) {
      return *gears[j].ratio / *gears[i].ratio;
    }
  }
  return std::nullopt;
}

void add_equal_ratios(std::span<const TableGear> gears, ShiftTable& table) {
  for (std::size_t i = 0; i < gears.size();) {
    std::vector<int> alike = {gears[i].state};
    std::size_t j = i + 1;
    while (j < gears.size() && is_same(gears[i], gears[j])) {
      alike.push_back(gears[j++].state);
    }
    if (alike.size() > 1) {
      table.equal_ratios.push_back(std::move(alike));
    }
    i = j;
  }
}

std::optional<double> slip_sum(const TableGear& before, const std::vector<int>& engages) {
  double sum = 0.0;
  for (const int element : engages) {
    const auto e = static_cast<std::size_t>(element);
    if (e >= before.slips.size() || !before.slips[e]) {
      return std::nullopt;
    }
    sum += std::abs(*before.slips[e]);
  }
  return sum;
}

GearChange change_between(const TableGear& from, const TableGear& to) {
  GearChange change;
  change.from = from.state;
  change.to = to.state;
  std::ranges::set_difference(from.engaged, to.engaged, std::back_inserter(change.opens));
  std::ranges::set_difference(to.engaged, from.engaged, std::back_inserter(change.engages));
  change.slip = slip_sum(from, change.engages);
  change.slip_back = slip_sum(to, change.opens);
  return change;
}

// Whether the second is the next forward gear after the first, or of its ratio.
bool is_next(std::span<const TableGear> gears,
             double forward,
             std::size_t first,
             std::size_t second) {
  if (group_of(gears[first], forward) != 0 || group_of(gears[second], forward) != 0) {
    return false;
  }
  std::size_t next = first + 1;
  while (next < gears.size() && is_same(gears[first], gears[next])) {
    ++next;
  }
  return second >= next && (second == next || is_same(gears[next], gears[second]));
}

}  // namespace

double find_forward_sign(std::span<const TableGear> gears) {
  const auto negative = std::ranges::count_if(
      gears, [](const TableGear& gear) { return gear.ratio.value_or(0.0) < 0.0; });
  const auto positive = std::ranges::count_if(
      gears, [](const TableGear& gear) { return gear.ratio.value_or(0.0) > 0.0; });
  return negative > positive ? -1.0 : 1.0;
}

void sort_gears(std::vector<TableGear>& gears, double forward) {
  std::ranges::stable_sort(gears, [forward](const TableGear& a, const TableGear& b) {
    const int first = group_of(a, forward);
    const int second = group_of(b, forward);
    if (first != second) {
      return first < second;
    }
    return a.ratio && !is_same(a, b) && std::abs(*a.ratio) > std::abs(*b.ratio);
  });
}

ShiftTable make_shift_table(std::span<const TableGear> gears, double forward) {
  ShiftTable table;
  table.forward = forward;
  for (std::size_t i = 0; i < gears.size(); ++i) {
    table.steps.push_back(step_of(gears, forward, i));
    for (std::size_t j = i + 1; j < gears.size(); ++j) {
      GearChange change = change_between(gears[i], gears[j]);
      const bool is_of_one = change.opens.size() <= 1 && change.engages.size() <= 1;
      if (change.elements() > 0 && (is_of_one || is_next(gears, forward, i, j))) {
        if (group_of(gears[i], forward) == 0 && group_of(gears[j], forward) == 0) {
          change.step = *gears[i].ratio / *gears[j].ratio;
        }
        table.changes.push_back(std::move(change));
      }
    }
  }
  const auto reverse = std::ranges::find_if(
      gears, [forward](const TableGear& gear) { return group_of(gear, forward) != 0; });
  if (reverse - gears.begin() > 1) {
    table.span = *gears.front().ratio / *std::prev(reverse)->ratio;
  }
  add_equal_ratios(gears, table);
  return table;
}

}  // namespace kinestat
