#include "studies/synthesis/task/task_positions.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "expression/evaluate.hpp"
#include "mechanism/check/value_by_rounding.hpp"
#include "studies/synthesis/positions/specification.hpp"

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
          "choose a 'free_point' off that line"};
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

// Where the file says what is wrong.
SourceRange place_of(SpecificationFault fault,
                     const PositionDescription& position,
                     const std::vector<SynthesisRange>& vary) {
  const CurvatureDescription& curvature = *position.curvature;
  const auto range_of = [&](FreeNumber which) {
    const auto range = std::ranges::find(vary, which, &SynthesisRange::which);
    return range == vary.end() ? curvature.where : range->name_where;
  };
  switch (fault) {
    case SpecificationFault::none:
    case SpecificationFault::no_inflection_circle:
      break;
    case SpecificationFault::point_in_pole:
      return position.pole->where;
    case SpecificationFault::free_point_in_pole:
    case SpecificationFault::aligned_points:
      return curvature.free_point ? curvature.free_point->where : range_of(FreeNumber::free_point);
    case SpecificationFault::centre_off_normal:
    case SpecificationFault::centre_in_point:
      return curvature.centre.where;
    case SpecificationFault::zero_ratio:
      return curvature.m ? curvature.m->where : range_of(FreeNumber::m);
  }
  return curvature.where;
}

SpecifiedPosition specified(const PositionSpecification& given, const SynthesisChoice& choice) {
  return choice.freedom ? find_jets(given, *choice.freedom) : find_jets(given);
}

// Ranges have doubles, and a task with many digits has no ranges.
SpecifiedPositionOf<BigFloat> specified(const PositionSpecificationOf<BigFloat>& given,
                                        const SynthesisChoice& /*choice*/) {
  return find_precise_jets(given);
}

double digits_of(double value, const Value& /*where*/, Diagnostics& /*found*/) {
  return value;
}

BigFloat digits_of(const ExactInput& value, const Value& where, Diagnostics& found) {
  if (!value.precise) {
    refuse_value_by_rounding(where, found);
  }
  return value.precise.value_or(BigFloat(value.value));
}

}  // namespace

template <class Number>
TaskPositions<Number>::TaskPositions(const MechanismDescription& description)
    : description_(description),
      task_(*description.synthesis),
      table_(evaluate_parameters<Number>(parameters_of(description)).table) {}

template <class Number>
auto TaskPositions<Number>::number(const Value& value, QuantityKind kind, Diagnostics& found) const
    -> Scalar {
  const auto result =
      evaluate_as<Number>(kind, value.expression, description_.units, table_.lookup(), {});
  KINESTAT_EXPECTS(std::holds_alternative<Number>(result));
  return digits_of(std::get<Number>(result), value, found);
}

template <class Number>
auto TaskPositions<Number>::point(const PointDescription& point, Diagnostics& found) const
    -> Point {
  const Scalar x = number(point.coordinates[0], QuantityKind::length, found);
  const Scalar y = number(point.coordinates[1], QuantityKind::length, found);
  return Point(x, y);
}

template <class Number>
auto TaskPositions<Number>::with_derivatives(const PositionDescription& position,
                                             const Scalar& angle,
                                             Diagnostics& found) const -> PositionJetsOf<Scalar> {
  const Point at = point(position.at, found);
  PositionJetsOf<Scalar> jets{.x = {at.real()}, .y = {at.imag()}, .angle = {angle}};
  jets.is_directed = position.derivatives.front().angle.has_value();
  for (const PoseDerivative& derivative : position.derivatives) {
    const Point moved = point(derivative.at, found);
    jets.x.push_back(moved.real());
    jets.y.push_back(moved.imag());
    const Scalar by_angle(jets.angle.size() == 1 ? 1 : 0);
    jets.angle.push_back(derivative.angle ? number(*derivative.angle, QuantityKind::angle, found)
                                          : by_angle);
  }
  return jets;
}

template <class Number>
auto TaskPositions<Number>::position(std::size_t index,
                                     const Scalar& angle,
                                     const SynthesisChoice& choice,
                                     Diagnostics& found) const
    -> std::optional<PositionJetsOf<Scalar>> {
  const PositionDescription& given = task_.positions[index];
  const int errors_before = found.error_count();
  if (!given.derivatives.empty()) {
    auto jets = with_derivatives(given, angle, found);
    if (jets.x[1] == 0 && jets.y[1] == 0 && jets.angle[1] == 0) {
      found.error(
          "E0801",
          given.derivatives.front().at.where,
          fmt::format(
              "position {}: its first derivative is zero, so that the plane is at rest there",
              index + 1),
          "give the derivatives by a parameter at which the plane moves, or leave them out");
    }
    return found.error_count() == errors_before ? std::optional(std::move(jets)) : std::nullopt;
  }
  PositionSpecificationOf<Scalar> specification{.at = point(given.at, found), .angle = angle};
  if (given.pole) {
    specification.pole = point(*given.pole, found);
  }
  if (given.curvature) {
    const CurvatureDescription& curvature = *given.curvature;
    CurvatureSpecificationOf<Scalar> values{.centre = point(curvature.centre, found),
                                            .free_point = {}};
    if (choice.free_point) {
      values.free_point = Point(choice.free_point->real(), choice.free_point->imag());
    } else if (curvature.free_point) {
      values.free_point = point(*curvature.free_point, found);
    }
    if (choice.m) {
      values.ratio = Scalar(*choice.m);
    } else if (curvature.m) {
      values.ratio = number(*curvature.m, QuantityKind::dimensionless, found);
    }
    specification.curvature = values;
  }
  specification.is_stationary = given.stationary;
  specification.is_burmester = given.burmester;
  if (found.error_count() != errors_before) {
    return std::nullopt;
  }
  auto result = specified(specification, choice);
  if (!result.jets) {
    const auto [message, hint] = words_of(result.fault);
    found.error("E0801",
                place_of(result.fault, given, task_.vary),
                fmt::format("position {}: {}", index + 1, message),
                hint);
  }
  return std::move(result.jets);
}

template <class Number>
std::size_t TaskPositions<Number>::count() const {
  std::size_t count = 1;
  for (const PositionDescription& position : task_.positions) {
    count *= position.angles.size();
  }
  return count;
}

template <class Number>
auto TaskPositions<Number>::of_task(std::size_t task,
                                    const SynthesisChoice& choice,
                                    Diagnostics& found) const -> std::optional<Positions> {
  Positions positions;
  std::size_t choices = count();
  for (std::size_t i = 0; i < task_.positions.size(); ++i) {
    const std::vector<Value>& angles = task_.positions[i].angles;
    choices /= angles.size();
    const Value& angle = angles[task / choices % angles.size()];
    auto jets = position(i, number(angle, QuantityKind::angle, found), choice, found);
    if (!jets) {
      return std::nullopt;
    }
    positions.push_back(*std::move(jets));
  }
  return positions;
}

template <class Number>
auto TaskPositions<Number>::of_tasks(const SynthesisChoice& choice, Diagnostics& found) const
    -> std::optional<std::vector<Positions>> {
  std::vector<Positions> tasks;
  for (std::size_t i = 0; i < count(); ++i) {
    auto positions = of_task(i, choice, found);
    if (!positions) {
      return std::nullopt;
    }
    tasks.push_back(*std::move(positions));
  }
  return tasks;
}

template class TaskPositions<double>;
template class TaskPositions<ExactInput>;

}  // namespace kinestat
