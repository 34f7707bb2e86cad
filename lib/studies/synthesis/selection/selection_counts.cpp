#include "studies/synthesis/selection/selection_counts.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace kinestat {

namespace {

template <std::size_t kSize>
void add_each(const std::array<int, kSize>& from, std::array<int, kSize>& to) {
  std::ranges::transform(to, from, to.begin(), std::plus());
}

}  // namespace

void SelectionCounts::add(const Defects& all) {
  const auto worst = static_cast<std::size_t>(all.worst());
  ++samples;
  ++with_linkage;
  ++defects[worst];
  usable += all.is_empty() ? 1 : 0;
  one_limit[worst] += all.are_of_limits() && all.count() == 1 ? 1 : 0;
}

void SelectionCounts::add(Missing what) {
  ++samples;
  ++missing[static_cast<std::size_t>(what)];
}

SelectionCounts& SelectionCounts::operator+=(const SelectionCounts& other) {
  samples += other.samples;
  with_linkage += other.with_linkage;
  usable += other.usable;
  add_each(other.defects, defects);
  add_each(other.missing, missing);
  add_each(other.one_limit, one_limit);
  return *this;
}

}  // namespace kinestat
