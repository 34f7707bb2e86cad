#include "run/internal/synthesis_task.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "expression/evaluate.hpp"

namespace kinestat {

namespace {

// What is wrong, and what to give instead.
std::pair<std::string, std::string> words_of(SpecificationFault fault) {
  switch (fault) {
    case SpecificationFault::none:
      break;
    case SpecificationFault::point_in_pole:
      return {"'at' is the pole, where a path has a cusp and no centre of curvature",
              "move 'at', or leave out 'curvature'"};
    case SpecificationFault::free_point_in_pole:
      return {"'free_point' is the pole, where a path has a cusp and no centre of curvature",
              "choose another 'free_point'"};
    case SpecificationFault::aligned_points:
      return {
          "'at', 'free_point' and 'pole' lie on one line, on which one curvature gives the other",
          "choose a 'free_point' beside that line"};
    case SpecificationFault::centre_off_normal:
      return {"'centre' does not lie on the line from 'at' to 'pole', the normal of the path",
              "move 'centre' on that line, or correct 'pole'"};
    case SpecificationFault::centre_in_point:
      return {"'centre' is 'at': the path would have no radius", "move 'centre' along the normal"};
    case SpecificationFault::zero_ratio:
      return {"'m' is zero: the path of 'free_point' would have no radius",
              "write a ratio other than zero"};
    case SpecificationFault::no_inflection_circle:
      return {"the inflection circle is a point, so that no higher curvature can be asked for",
              "leave out 'stationary' and 'burmester', or change 'centre' or 'm'"};
  }
  return {};
}

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

SynthesisValues::SynthesisValues(const MechanismDescription& description)
    : description_(description),
      task_(*description.synthesis),
      table_(evaluate_parameters(parameters_of(description)).table) {}

double SynthesisValues::number(const Value& value, QuantityKind kind) const {
  const auto result = evaluate_as(kind, value.expression, description_.units, table_.lookup(), {});
  KINESTAT_EXPECTS(std::holds_alternative<double>(result));
  return std::get<double>(result);
}

Point SynthesisValues::point(const PointDescription& point) const {
  return {number(point.coordinates[0], QuantityKind::length),
          number(point.coordinates[1], QuantityKind::length)};
}

PositionJets SynthesisValues::with_derivatives(const PositionDescription& position,
                                               double angle) const {
  PositionJets jets = finite_position(point(position.at), angle);
  for (const PoseDerivative& derivative : position.derivatives) {
    const Point at = point(derivative.at);
    jets.x.push_back(at.real());
    jets.y.push_back(at.imag());
    const double by_angle = jets.angle.size() == 1 ? 1.0 : 0.0;
    jets.angle.push_back(derivative.angle ? number(*derivative.angle, QuantityKind::dimensionless)
                                          : by_angle);
  }
  return jets;
}

std::optional<PositionJets> SynthesisValues::position(std::size_t index,
                                                      double angle,
                                                      const SynthesisChoice& choice,
                                                      Diagnostics& found) const {
  const PositionDescription& given = task_.positions[index];
  if (!given.derivatives.empty()) {
    PositionJets jets = with_derivatives(given, angle);
    if (jets.x[1] == 0.0 && jets.y[1] == 0.0 && jets.angle[1] == 0.0) {
      found.error(
          "E0801",
          given.where,
          fmt::format("position {}: its first derivative is zero, so that the plane stands "
                      "still there",
                      index + 1),
          "give the derivatives by a parameter at which the plane moves, or leave them out");
      return std::nullopt;
    }
    return jets;
  }
  PositionSpecification specification{.at = point(given.at), .angle = angle};
  if (given.pole) {
    specification.pole = point(*given.pole);
  }
  if (given.curvature) {
    const CurvatureDescription& curvature = *given.curvature;
    const Point free_point = choice.free_point ? *choice.free_point : point(*curvature.free_point);
    const double m = choice.m ? *choice.m : number(*curvature.m, QuantityKind::dimensionless);
    specification.curvature = CurvatureSpecification{
        .centre = point(curvature.centre), .free_point = free_point, .ratio = m};
  }
  specification.is_stationary = given.stationary;
  specification.is_burmester = given.burmester;
  SpecifiedPosition result = find_jets(specification);
  if (!result.jets) {
    const auto [message, hint] = words_of(result.fault);
    found.error("E0801", given.where, fmt::format("position {}: {}", index + 1, message), hint);
  }
  return std::move(result.jets);
}

std::optional<std::vector<std::vector<PositionJets>>> SynthesisValues::positions_of_tasks(
    const SynthesisChoice& choice, Diagnostics& found) const {
  std::vector<std::vector<PositionJets>> tasks(1);
  for (std::size_t i = 0; i < task_.positions.size(); ++i) {
    std::vector<std::vector<PositionJets>> longer;
    for (const std::vector<PositionJets>& task : tasks) {
      for (const Value& angle : task_.positions[i].angles) {
        const auto jets = position(i, number(angle, QuantityKind::angle), choice, found);
        if (!jets) {
          return std::nullopt;
        }
        longer.push_back(task);
        longer.back().push_back(*jets);
      }
    }
    tasks = std::move(longer);
  }
  return tasks;
}

std::vector<SelectionRange> SynthesisValues::ranges() const {
  constexpr double kSamples = 4000.0;
  std::vector<SelectionRange> result;
  for (const SynthesisRange& range : task_.vary) {
    const QuantityKind kind =
        range.name.text == "m" ? QuantityKind::dimensionless : QuantityKind::length;
    for (std::size_t i = 0; i < range.from.size(); ++i) {
      result.push_back({.from = number(range.from[i], kind), .to = number(range.to[i], kind)});
    }
  }
  const double each = std::pow(kSamples, 1.0 / static_cast<double>(result.size()));
  for (SelectionRange& range : result) {
    range.count = static_cast<int>(each) + 1;
  }
  return result;
}

SynthesisChoice SynthesisValues::choice_of(std::span<const double> numbers) const {
  SynthesisChoice choice;
  std::size_t at = 0;
  for (const SynthesisRange& range : task_.vary) {
    if (range.name.text == "m") {
      choice.m = numbers[at];
    } else {
      choice.free_point = Point(numbers[at], numbers[at + 1]);
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

std::optional<int> SynthesisValues::curve_count() const {
  return task_.curve_count ? std::optional(static_cast<int>(
                                 number(*task_.curve_count, QuantityKind::dimensionless)))
                           : std::nullopt;
}

}  // namespace kinestat
