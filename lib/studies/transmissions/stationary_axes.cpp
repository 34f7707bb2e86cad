#include "studies/transmissions/stationary_axes.hpp"

#include <algorithm>
#include <cmath>

namespace kinestat {

namespace {

// Ranges of which the ends differ by less are not cut: a requirement is met on an edge alone.
constexpr double kNarrow = 1.02;

constexpr double kThousand = 1000.0;

}  // namespace

StationaryAxes::StationaryAxes(const TransmissionTask& task, const RoleChoice& choice)
    : sets_(static_cast<std::size_t>(task.sets())) {
  for (std::size_t s = 0; s < sets_; ++s) {
    const auto kind = static_cast<std::size_t>(choice.kind_of(static_cast<int>(s)));
    axes_[s] = &task.stationary_ratios[kind];
    is_grid_ = is_grid_ && has_list(s) && axes_[s]->tries_all;
  }
}

AxisPart StationaryAxes::part_of_list(std::size_t set, std::size_t first, std::size_t last) const {
  return {.from = values(set)[first], .to = values(set)[last], .first = first, .last = last};
}

StationaryPart StationaryAxes::whole() const {
  StationaryPart part;
  for (std::size_t s = 0; s < sets_; ++s) {
    part[s] = has_list(s) ? part_of_list(s, 0, values(s).size() - 1)
                          : AxisPart{.from = range(s).from, .to = range(s).to};
  }
  return part;
}

bool StationaryAxes::is_corners(const StationaryPart& part) const {
  return is_grid_ && std::all_of(part.begin(),
                                 part.begin() + static_cast<std::ptrdiff_t>(sets_),
                                 [](const AxisPart& one) { return one.last - one.first <= 1; });
}

StationaryBox StationaryAxes::box(const StationaryPart& part) const {
  StationaryBox box;
  for (std::size_t s = 0; s < sets_; ++s) {
    box.from[s] = part[s].from;
    box.to[s] = part[s].to;
  }
  return box;
}

double StationaryAxes::nearest(std::size_t set, double value) const {
  if (!has_list(set)) {
    const double rounded = std::round(value * kThousand) / kThousand;
    return std::clamp(rounded, range(set).from, range(set).to);
  }
  const std::vector<double>& list = values(set);
  const auto above = std::ranges::lower_bound(list, value);
  if (above == list.begin() || (above != list.end() && *above - value < value - *(above - 1))) {
    return *above;
  }
  return *(above - 1);
}

double StationaryAxes::neighbour(std::size_t set, double value, double step) const {
  if (!has_list(set)) {
    return nearest(set, value + step);
  }
  const std::vector<double>& list = values(set);
  const auto at = std::ranges::lower_bound(list, value);
  if (at == (step < 0.0 ? list.begin() : list.end() - 1)) {
    return value;
  }
  const double next = *(step < 0.0 ? at - 1 : at + 1);
  const double near = axes_[set]->tries_all ? next : nearest(set, value + step);
  return near == value ? next : near;
}

bool StationaryAxes::is_point(const StationaryPart& part) const {
  return std::all_of(part.begin(),
                     part.begin() + static_cast<std::ptrdiff_t>(sets_),
                     [](const AxisPart& one) { return one.from == one.to; });
}

StationaryPoint StationaryAxes::middle(const StationaryPart& part) const {
  StationaryPoint point{};
  for (std::size_t s = 0; s < sets_; ++s) {
    const double halfway = (part[s].from + part[s].to) / 2.0;
    point[s] = has_list(s) ? values(s)[(part[s].first + part[s].last) / 2] : nearest(s, halfway);
  }
  return point;
}

bool StationaryAxes::halve(const StationaryPart& part,
                           std::array<StationaryPart, 2>& halves) const {
  std::size_t widest = sets_;
  double width = 1.0;
  for (std::size_t s = 0; s < sets_; ++s) {
    const double its = part[s].to / part[s].from;
    const bool can_be_cut = has_list(s) ? part[s].last > part[s].first : its > kNarrow;
    if (can_be_cut && its > width) {
      width = its;
      widest = s;
    }
  }
  if (widest == sets_) {
    return false;
  }
  halves = {part, part};
  const AxisPart& whole = part[widest];
  if (has_list(widest)) {
    const std::size_t middle = (whole.first + whole.last) / 2;
    halves[0][widest] = part_of_list(widest, whole.first, middle);
    halves[1][widest] = part_of_list(widest, middle + 1, whole.last);
  } else {
    halves[0][widest].to = (whole.from + whole.to) / 2.0;
    halves[1][widest].from = halves[0][widest].to;
  }
  return true;
}

}  // namespace kinestat
