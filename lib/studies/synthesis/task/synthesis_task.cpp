#include "studies/synthesis/task/synthesis_task.hpp"

#include <algorithm>

namespace kinestat {

namespace {

std::optional<LinkageType> type_of(LinkageKind kind) {
  switch (kind) {
    case LinkageKind::any:
      return std::nullopt;
    case LinkageKind::four_bar:
      return LinkageType::four_bar;
    case LinkageKind::slider_crank:
      return LinkageType::slider_crank;
    case LinkageKind::inverted_slider_crank:
      return LinkageType::inverted_slider_crank;
  }
  return std::nullopt;
}

}  // namespace

SynthesisTask solve_task(std::vector<PositionJets> positions,
                         const LinkageLimits& limits,
                         const LastDecimal& decimal) {
  SynthesisTask task;
  task.positions = std::move(positions);
  const int count = position_count(task.positions);
  if (count == 5) {
    task.dyads = solve_burmester(task.positions, decimal);
    task.linkages = rank_linkages(task.dyads->dyads, task.positions, limits);
  } else if (count == 4) {
    task.curves = find_curves(task.positions);
  } else if (count == 3) {
    task.straight_paths = find_straight_path_circle(task.positions);
  }
  if (count < 4) {
    task.special = find_degeneracy(task.positions);
  }
  return task;
}

SynthesisValues::SynthesisValues(const MechanismDescription& description)
    : task_(*description.synthesis), positions_(description) {}

double SynthesisValues::number(const Value& value, QuantityKind kind) const {
  Diagnostics none;
  return positions_.number(value, kind, none);
}

std::optional<std::vector<std::vector<PositionJets>>> SynthesisValues::positions_of_tasks(
    const SynthesisChoice& choice, Diagnostics& found) const {
  return positions_.of_tasks(choice, found);
}

std::optional<std::vector<PositionJets>> SynthesisValues::positions_of_task(
    std::size_t task, const SynthesisChoice& choice, Diagnostics& found) const {
  return positions_.of_task(task, choice, found);
}

std::vector<SelectionRange> SynthesisValues::ranges() const {
  std::vector<SelectionRange> result;
  for (const SynthesisRange& range : task_.vary) {
    if (range.which == FreeNumber::circle_points) {
      continue;
    }
    const QuantityKind kind = kind_of(range.which);
    for (std::size_t i = 0; i < range.from.size(); ++i) {
      result.push_back({.from = number(range.from[i], kind), .to = number(range.to[i], kind)});
    }
  }
  for (SelectionRange& range : result) {
    range.count = samples_along(samples(), static_cast<double>(result.size()));
  }
  return result;
}

std::optional<CirclePointArea> SynthesisValues::circle_points() const {
  const auto range =
      std::ranges::find(task_.vary, FreeNumber::circle_points, &SynthesisRange::which);
  if (range == task_.vary.end()) {
    return std::nullopt;
  }
  const auto corner = [&](const std::vector<Value>& of) {
    return Point(number(of[0], QuantityKind::length), number(of[1], QuantityKind::length));
  };
  return CirclePointArea{.from = corner(range->from), .to = corner(range->to)};
}

int SynthesisValues::samples() const {
  return task_.samples ? static_cast<int>(number(*task_.samples, QuantityKind::dimensionless))
                       : kUsualSamples;
}

SynthesisChoice SynthesisValues::choice_of(std::span<const double> numbers) const {
  SynthesisChoice choice;
  const bool is_effective =
      std::ranges::find(task_.vary, FreeNumber::s, &SynthesisRange::which) != task_.vary.end();
  if (is_effective) {
    choice.freedom = EffectiveFreedom{};
  }
  std::size_t at = 0;
  for (const SynthesisRange& range : task_.vary) {
    switch (range.which) {
      case FreeNumber::m:
        choice.m = numbers[at];
        break;
      case FreeNumber::free_point:
        choice.free_point = Point(numbers[at], numbers[at + 1]);
        break;
      case FreeNumber::s:
        choice.freedom->s = numbers[at];
        break;
      case FreeNumber::tau:
        choice.freedom->tau = numbers[at];
        break;
      case FreeNumber::tau_2:
        choice.freedom->tau_2 = numbers[at];
        break;
      case FreeNumber::circle_points:
        break;
    }
    at += range.from.size();
  }
  return choice;
}

LinkageLimits SynthesisValues::limits() const {
  const SynthesisLimits& given = task_.limits;
  LinkageLimits limits;
  limits.type = type_of(task_.linkage);
  if (given.transmission_angle) {
    limits.transmission = number(*given.transmission_angle, QuantityKind::angle);
  }
  if (given.link_ratio) {
    limits.ratio = number(*given.link_ratio, QuantityKind::dimensionless);
  }
  if (given.size) {
    limits.size = number(*given.size, QuantityKind::length);
  }
  return limits;
}

std::optional<int> SynthesisValues::digits() const {
  return task_.digits
             ? std::optional(static_cast<int>(number(*task_.digits, QuantityKind::dimensionless)))
             : std::nullopt;
}

std::optional<int> SynthesisValues::curve_count() const {
  return task_.curve_count ? std::optional(static_cast<int>(
                                 number(*task_.curve_count, QuantityKind::dimensionless)))
                           : std::nullopt;
}

}  // namespace kinestat
