#include "mechanism/bind/evaluator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <variant>

#include <fmt/format.h>

#include "core/text.hpp"
#include "core/tolerance.hpp"
#include "core/utf8.hpp"
#include "expression/evaluate.hpp"
#include "mechanism/check/value_by_rounding.hpp"
#include "screw/exact_input_vector.hpp"

namespace kinestat {

namespace {

void report(const ParameterDescription& parameter, ExpressionError error, Diagnostics& found) {
  if (parameter.set_by.empty()) {
    const SourceRange where = place_in(parameter.value, error);
    found.error(error.code, where, std::move(error.message), std::move(error.hint));
  } else {
    found.error("E0102",
                {},
                fmt::format("--set '{}': {}", printable(parameter.set_by), error.message),
                error.hint);
  }
}

void report(const MechanismDescription& description,
            std::span<const ParameterError> errors,
            Diagnostics& found) {
  found.reserve(errors.size());
  for (const ParameterError& one : errors) {
    report(description.parameters[static_cast<std::size_t>(one.parameter)], one.error, found);
  }
}

void set_value(double& number, double value) {
  number = value;
}

// Derivatives stay, and the digits as typed.
template <class Scalar>
void set_value(Scalar& number, double value) {
  number.value = value;
}

// In a list of those of which ExactInput knows no digits.
template <class Scalar>
void note_rounding(const Value& value, const Scalar& number, std::vector<const Value*>& list) {
  if constexpr (std::is_same_v<Scalar, ExactInput>) {
    if (!number.precise && std::ranges::find(list, &value) == list.end()) {
      list.push_back(&value);
    }
  }
}

std::vector<int> free_parameters(const MechanismDescription& description) {
  std::vector<int> free;
  for (std::size_t i = 0; i < description.parameters.size(); ++i) {
    if (description.parameters[i].is_free) {
      free.push_back(static_cast<int>(i));
    }
  }
  return free;
}

// What may stand for a number in some places.
std::vector<std::string> words_beside_numbers(const MechanismDescription& description) {
  std::vector<std::string> words;
  for (const CurveDescription& curve : description.curves) {
    words.push_back(curve.name.text);
  }
  if (description.motion) {
    words.emplace_back(kLimitWord);
  }
  return words;
}

}  // namespace

Evaluator make_evaluator(const MechanismDescription& description, Diagnostics& found) {
  const std::vector<Parameter> parameters = parameters_of(description);
  ParameterValues values = evaluate_parameters(parameters);
  report(description, values.errors, found);
  report(description, find_dependent(parameters, free_parameters(description)), found);
  return {description, std::move(values.table), found};
}

template <class Scalar>
EvaluatorOf<Scalar> EvaluatorOf<Scalar>::complaining_to(Diagnostics& found) const {
  EvaluatorOf result(description_, table_, found);
  result.origin_ = origin_;
  result.exact_input_ = exact_input_;
  return result;
}

template <class Scalar>
void EvaluatorOf<Scalar>::measure_from(const LocalOrigin& origin) {
  origin_ = origin;
  if (!origin.is_world() && !exact_input_) {
    exact_input_ = std::make_shared<const BasicParameterTable<ExactInput>>(
        evaluate_parameters<ExactInput>(parameters_of(description_)).table);
  }
}

template <class Scalar>
std::span<const std::string> EvaluatorOf<Scalar>::known_names() const {
  return found_.is_hint_worth_it() ? table_.names() : std::span<const std::string>();
}

// A curve stands where numbers may move.
template <class Scalar>
void EvaluatorOf<Scalar>::complain(const Value& value, const ExpressionError& error) {
  const std::string_view text = value.expression.text();
  const auto offset = static_cast<std::size_t>(error.offset);
  const std::string_view name =
      offset < text.size() ? text.substr(offset, static_cast<std::size_t>(error.length)) : "";
  const bool is_curve = std::ranges::any_of(
      description_.curves, [&](const CurveDescription& curve) { return curve.name.text == name; });
  if (error.code == "E0311" && is_curve) {
    found_.error("E0311",
                 place_in(value, error),
                 fmt::format("'{}' is a curve, and this number does not move", name),
                 "curves belong in 'force' and 'couple' of loads and in 'action' of cases");
  } else {
    const bool may_guess = error.code == "E0311" && error.hint.empty();
    // What an option gives has no place in the file.
    const bool has_place = value.where.line > 0;
    found_.error(
        error.code,
        place_in(value, error),
        has_place ? error.message : fmt::format("'{}': {}", printable(text), error.message),
        may_guess ? did_you_mean(name, words_beside_numbers(description_)) : error.hint);
  }
}

template <class Scalar>
void EvaluatorOf<Scalar>::mark_used(const Value& value) {
  table_.mark_used(value.expression);
  if (noted_ != nullptr) {
    noted_->push_back(&value);
  }
}

template <class Scalar>
std::optional<Scalar> EvaluatorOf<Scalar>::number(const Value& value, QuantityKind kind) {
  mark_used(value);
  if (table_.is_failed(value.expression)) {
    return std::nullopt;
  }
  const auto result = evaluate_as<Scalar>(
      kind, value.expression, description_.units, table_.lookup(), known_names());
  if (const auto* error = std::get_if<ExpressionError>(&result)) {
    complain(value, *error);
    return std::nullopt;
  }
  const Scalar number = std::get<Scalar>(result);
  note_rounding(value, number, by_rounding_);
  if (kind == QuantityKind::angle) {
    warn_of_degrees(value, value_of(number));
  }
  return number;
}

// A bare number that counts in radians and is more than a full turn.
template <class Scalar>
void EvaluatorOf<Scalar>::warn_of_degrees(const Value& value, double angle) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  if (std::abs(angle) <= kTurn || description_.units.text(QuantityKind::angle) != "rad") {
    return;
  }
  const auto result = evaluate<Scalar>(value.expression, table_.lookup());
  if (std::holds_alternative<BasicQuantity<Scalar>>(result) &&
      is_bare(std::get<BasicQuantity<Scalar>>(result).dimension)) {
    found_.warning(
        "W0303",
        value.where,
        fmt::format("an angle of {} rad is more than a full turn", value.expression.text()),
        fmt::format("write {} deg, or 'units: {{angle: deg}}' for the whole file",
                    value.expression.text()));
  }
}

template <class Scalar>
std::optional<NumberLaw<Scalar>> EvaluatorOf<Scalar>::law(
    const Value& value, QuantityKind kind, std::span<const LawVariable<Scalar>> variables) {
  mark_used(value);
  if (table_.is_failed(value.expression)) {
    return std::nullopt;
  }
  std::map<std::string, BasicQuantity<Scalar>, std::less<>> parameters;
  for (const std::string& name : value.expression.names()) {
    const bool is_variable =
        std::ranges::find(variables, name, &LawVariable<Scalar>::name) != variables.end();
    const BasicQuantity<Scalar>* parameter = table_.find(name);
    if (is_variable && parameter != nullptr) {
      found_.error("E0307",
                   value.where,
                   fmt::format("'{}' is what this number depends on, and a parameter too", name),
                   "give the parameter another name");
      return std::nullopt;
    }
    if (parameter != nullptr) {
      parameters.emplace(name, *parameter);
    }
  }
  NumberLaw<Scalar> result(value.expression, kind, description_.units, std::move(parameters));
  const auto sample = result.at(variables);
  // Where it has a value is not known yet.
  if (const auto* error = std::get_if<ExpressionError>(&sample); error && error->code != "E0316") {
    found_.error(error->code, place_in(value, *error), error->message, error->hint);
    return std::nullopt;
  }
  return result;
}

template <class Scalar>
std::optional<BasicQuantity<Scalar>> EvaluatorOf<Scalar>::quantity(const Value& value) {
  mark_used(value);
  if (table_.is_failed(value.expression)) {
    return std::nullopt;
  }
  const auto result = evaluate<Scalar>(value.expression, table_.lookup(), known_names());
  if (const auto* error = std::get_if<ExpressionError>(&result)) {
    complain(value, *error);
    return std::nullopt;
  }
  return std::get<BasicQuantity<Scalar>>(result);
}

template <class Scalar>
std::optional<Vec3Of<Scalar>> EvaluatorOf<Scalar>::vector(const std::vector<Value>& components,
                                                          QuantityKind kind) {
  Vec3Of<Scalar> result = Vec3Of<Scalar>::Zero();
  bool is_good = true;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const std::optional<Scalar> coordinate = number(components[i], kind);
    is_good = is_good && coordinate.has_value();
    result[static_cast<Eigen::Index>(i)] = coordinate.value_or(Scalar(0.0));
  }
  return is_good ? std::optional(result) : std::nullopt;
}

template <class Scalar>
std::optional<Vec3Of<Scalar>> EvaluatorOf<Scalar>::point(const PointDescription& point) {
  std::optional<Vec3Of<Scalar>> place = vector(point.coordinates, QuantityKind::length);
  if (!place || origin_.is_world()) {
    return place;
  }
  *place = from_origin(*place);
  for (std::size_t i = 0; i < point.coordinates.size(); ++i) {
    Scalar& coordinate = (*place)[static_cast<Eigen::Index>(i)];
    const double origin = origin_.place()[static_cast<Eigen::Index>(i)];
    set_value(coordinate, from_origin(point.coordinates[i], origin).value_or(value_of(coordinate)));
  }
  return place;
}

template <class Scalar>
Vec3Of<Scalar> EvaluatorOf<Scalar>::from_origin(const Vec3Of<Scalar>& in_world) const {
  return origin_.is_world() ? in_world
                            : Vec3Of<Scalar>(in_world - origin_.place().template cast<Scalar>());
}

// Empty where the digits of the number are not known.
template <class Scalar>
std::optional<double> EvaluatorOf<Scalar>::from_origin(const Value& coordinate,
                                                       double origin) const {
  const auto result = evaluate_as<ExactInput>(
      QuantityKind::length, coordinate.expression, description_.units, exact_input_->lookup());
  const ExactInput* const number = std::get_if<ExactInput>(&result);
  if (number == nullptr) {
    return std::nullopt;
  }
  const ExactInput local = *number - ExactInput(origin);
  return local.precise ? std::optional(static_cast<double>(*local.precise)) : std::nullopt;
}

// A zero that is typed without a unit is of every dimension.
template <class Scalar>
std::optional<Vec3Of<Scalar>> EvaluatorOf<Scalar>::direction(const std::vector<Value>& components) {
  Vec3Of<Scalar> result = Vec3Of<Scalar>::Zero();
  std::optional<Dimension> common;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const Value& component = components[i];
    const std::optional<BasicQuantity<Scalar>> one = quantity(component);
    if (!one) {
      return std::nullopt;
    }
    note_rounding(component, one->value, by_rounding_);
    result[static_cast<Eigen::Index>(i)] = one->value;
    if (component.expression.names().empty() && is_bare(one->dimension) &&
        value_of(one->value) == 0.0) {
      continue;
    }
    if (common && *common != one->dimension) {
      found_.error("E0309",
                   component.where,
                   fmt::format("a direction of {} and {} has no meaning",
                               phrase_of(*common),
                               phrase_of(one->dimension)),
                   "give all of its components the same unit, or none; only a 0 needs no unit");
      return std::nullopt;
    }
    common = one->dimension;
  }
  return !common || is_bare(*common) ? vector(components, QuantityKind::dimensionless)
                                     : std::optional(result);
}

template <class Scalar>
std::optional<AxisOf<Scalar>> EvaluatorOf<Scalar>::axis(const AxisDescription& axis) {
  if (axis.keyword != 0) {
    return AxisOf<Scalar>{.direction = Scalar(axis.sign) * Vec3Of<Scalar>::Unit(axis.keyword - 'x'),
                          .keyword = axis.keyword};
  }
  const std::optional<Vec3Of<Scalar>> components = direction(axis.components);
  if (!components) {
    return std::nullopt;
  }
  if (values_of<Scalar>(*components).norm() <= kZeroAxis) {
    found_.error("E0314",
                 axis.where,
                 "a direction of zero length points nowhere",
                 "write x, y, z, -x, … or a vector such as [1, 0, 0.5]");
    return std::nullopt;
  }
  return AxisOf<Scalar>{.direction = unit_along<Scalar>(*components), .keyword = 0};
}

template <class Scalar>
void EvaluatorOf<Scalar>::warn_of_unused() const {
  for (const int i : table_.unused()) {
    const Name& name = description_.parameters[static_cast<std::size_t>(i)].name;
    found_.warning("W0301",
                   name.where,
                   fmt::format("parameter '{}' is never used", name.text),
                   "use it or remove it");
  }
}

template <class Scalar>
void EvaluatorOf<Scalar>::refuse_values_by_rounding() const {
  for (const Value* value : by_rounding_) {
    refuse_value_by_rounding(*value, found_);
  }
}

template class EvaluatorOf<double>;
template class EvaluatorOf<Dual>;
template class EvaluatorOf<ExactInput>;

}  // namespace kinestat
