#include "studies/synthesis/task/synthesis_task.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/tolerance.hpp"
#include "studies/synthesis/task/given_dyad_fault.hpp"

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

// Each coupler has two cranks, also one that is not real.
void keep_couplers(const AngleFunction& function, BurmesterSolution& solution) {
  solution.dyads = cranks_of_couplers(function, solution.dyads);
  solution.imaginary_count *= 2;
  solution.nearest.reset();
}

}  // namespace

SynthesisTask solve_task(std::vector<PositionJets> positions,
                         const LinkageLimits& limits,
                         const LastDecimal& decimal,
                         const std::vector<Dyad>& given) {
  SynthesisTask task;
  task.positions = std::move(positions);
  const int count = position_count(task.positions);
  if (count == 5) {
    task.dyads = solve_burmester(task.positions, decimal);
    if (limits.function) {
      keep_couplers(*limits.function, *task.dyads);
    }
    task.linkages = rank_linkages(task.dyads->dyads, task.positions, limits);
  } else if (count == 4) {
    task.curves = find_curves(task.positions);
  } else if (count == 3 && !limits.function) {
    task.straight_paths = find_straight_path_circle(task.positions);
  }
  if (count < 4) {
    task.special = find_degeneracy(task.positions);
  }
  if (!given.empty()) {
    add_dyads(given, task.curves, limits, task);
  }
  return task;
}

void add_dyads(std::vector<Dyad> dyads,
               const std::optional<FourPositionCurves>& curves,
               const LinkageLimits& limits,
               SynthesisTask& task) {
  task.dyads = BurmesterSolution{.dyads = std::move(dyads)};
  if (curves) {
    task.dyads->digits = curves->digits;
    task.dyads->reciprocal_condition = curves->reciprocal_condition;
  }
  task.linkages = rank_linkages(task.dyads->dyads, task.positions, limits);
}

SynthesisValues::SynthesisValues(const MechanismDescription& description)
    : description_(description), task_(*description.synthesis), positions_(description) {}

double SynthesisValues::number(const Value& value, QuantityKind kind) const {
  Diagnostics none;
  return positions_.number(value, kind, none);
}

Point SynthesisValues::point(const std::vector<Value>& coordinates) const {
  return {number(coordinates[0], QuantityKind::length),
          number(coordinates[1], QuantityKind::length)};
}

std::optional<PlaneArea> SynthesisValues::area(const std::optional<AreaDescription>& area) const {
  if (!area) {
    return std::nullopt;
  }
  std::vector<Point> corners;
  for (const PointDescription& corner : area->corners) {
    corners.push_back(point(corner.coordinates));
  }
  return corners.size() == 2 ? PlaneArea::between(corners[0], corners[1])
                             : PlaneArea(std::move(corners));
}

namespace {

// No linkage is made of two dyads between the same points.
bool are_alike(const Dyad& one, const Dyad& other) {
  const double size = std::abs(one.circle_point) + std::abs(one.centre_point);
  return one.kind == other.kind &&
         std::abs(one.circle_point - other.circle_point) <= kSameValue * size &&
         std::abs(one.centre_point - other.centre_point) <= kSameValue * size &&
         std::abs(one.direction - other.direction) <= kSameValue;
}

}  // namespace

GivenDyad SynthesisValues::given(const DyadDescription& dyad) const {
  GivenDyad result;
  if (dyad.circle_point) {
    result.circle_point = point(dyad.circle_point->coordinates);
    result.rounding = rounding_of(*dyad.circle_point, description_);
  }
  if (dyad.centre_point) {
    result.centre_point = point(dyad.centre_point->coordinates);
    result.rounding = std::max(result.rounding, rounding_of(*dyad.centre_point, description_));
  }
  return result;
}

std::optional<std::vector<Dyad>> SynthesisValues::given_dyads(
    std::span<const PositionJets> positions, Diagnostics& found) const {
  if (task_.function) {
    return given_cranks(positions, found);
  }
  std::vector<Dyad> dyads;
  for (std::size_t i = 0; i < task_.dyads.size(); ++i) {
    const CompletedDyad completed = complete_dyad(positions, given(task_.dyads[i]));
    if (!completed.dyad) {
      add_fault(completed, i, positions, description_, found);
      return std::nullopt;
    }
    if (!dyads.empty() && are_alike(dyads.back(), *completed.dyad)) {
      found.error("E0307",
                  task_.dyads[i].where,
                  fmt::format("dyad {} is the same as dyad {}", i + 1, i),
                  "two different dyads make a linkage: give it other points, or leave it out");
      return std::nullopt;
    }
    dyads.push_back(*completed.dyad);
  }
  return dyads;
}

// Seen from the output, the pivot on the input is a circle point, and that on the output its
// centre.
std::optional<std::vector<Dyad>> SynthesisValues::given_cranks(
    std::span<const PositionJets> positions, Diagnostics& found) const {
  const auto& [input, output, where] = *task_.function;
  if (!input.circle_point && !output.circle_point) {
    return std::vector<Dyad>{};
  }
  const DyadDescription coupler{
      .circle_point = input.circle_point, .centre_point = output.circle_point, .where = where};
  const CompletedDyad completed = complete_dyad(positions, given(coupler));
  if (!completed.dyad) {
    add_fault(completed, 0, positions, description_, found);
    return std::nullopt;
  }
  std::vector<Dyad> cranks = cranks_of_couplers(*function(), {&*completed.dyad, 1});
  if (cranks.empty()) {
    found.error("E0305",
                (input.circle_point ? input.circle_point : output.circle_point)->where,
                "with this 'circle_point' a link has no length, or an infinite one",
                "move it: it is a fixed pivot, or the other pivot of the coupler lies at infinity");
    return std::nullopt;
  }
  return cranks;
}

std::optional<AngleFunction> SynthesisValues::function() const {
  if (!task_.function) {
    return std::nullopt;
  }
  const auto angles = [&](const FunctionLink& link) {
    const double first = number(link.angles.front(), QuantityKind::angle);
    std::vector<double> result;
    for (const Value& angle : link.angles) {
      result.push_back(number(angle, QuantityKind::angle) - first);
    }
    return result;
  };
  return AngleFunction{.input_pivot = point(task_.function->input.centre_point.coordinates),
                       .output_pivot = point(task_.function->output.centre_point.coordinates),
                       .input = angles(task_.function->input),
                       .output = angles(task_.function->output)};
}

std::optional<std::vector<std::vector<PositionJets>>> SynthesisValues::positions_of_tasks(
    const SynthesisChoice& choice, Diagnostics& found) const {
  if (const auto angles = function()) {
    return std::vector<std::vector<PositionJets>>{seen_from_output(*angles)};
  }
  return positions_.of_tasks(choice, found);
}

std::optional<std::vector<PositionJets>> SynthesisValues::positions_of_task(
    std::size_t task, const SynthesisChoice& choice, Diagnostics& found) const {
  return positions_.of_task(task, choice, found);
}

std::vector<SelectionRange> SynthesisValues::ranges() const {
  std::vector<SelectionRange> result;
  for (const SynthesisRange& range : task_.vary) {
    if (chooses_dyads(range.which)) {
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

std::optional<ChoiceArea> SynthesisValues::choice_area() const {
  const auto range = std::ranges::find_if(
      task_.vary, [](const SynthesisRange& one) { return chooses_dyads(one.which); });
  if (range == task_.vary.end()) {
    return std::nullopt;
  }
  return ChoiceArea{.from = point(range->from),
                    .to = point(range->to),
                    .of = range->which == FreeNumber::circle_points ? DyadPoint::circle_point
                                                                    : DyadPoint::centre_point};
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
      case FreeNumber::centre_points:
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
  if (given.full_transmission_angle) {
    limits.full_transmission = number(*given.full_transmission_angle, QuantityKind::angle);
  }
  if (given.link_ratio) {
    limits.ratio = number(*given.link_ratio, QuantityKind::dimensionless);
  }
  if (given.size) {
    limits.size = number(*given.size, QuantityKind::length);
  }
  limits.classes = given.classes;
  limits.circuits = given.circuits;
  limits.turns_fully = given.turns_fully;
  limits.function = function();
  limits.circle_points = area(given.circle_points);
  limits.centre_points = area(given.centre_points);
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
