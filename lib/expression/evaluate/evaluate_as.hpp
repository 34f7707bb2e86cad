// The functions of evaluate.hpp for any type of number; each type has one source that includes
// this.
#pragma once

#include <cmath>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include "core/contract.hpp"
#include "core/tolerance.hpp"
#include "expression/evaluate.hpp"
#include "expression/evaluate/evaluation.hpp"
#include "expression/parse/regroup.hpp"

namespace kinestat {

/// A number counted in a unit, in SI.
template <class Number>
Number in_si(const Number& count, const UnitScale& unit) {
  if constexpr (std::same_as<Number, double>) {
    return unit.to_si(count);
  } else {
    Number result = NumberTraits<Number>::to_si(count, unit);
    result.value = unit.to_si(count.value);
    return result;
  }
}

/// Whether answers are proportional to it.
inline bool is_known_magnitude(QuantityKind kind) {
  using enum QuantityKind;
  return kind == force || kind == moment || kind == velocity || kind == angular_velocity;
}

/// The largest number of a kind that is computed with [SI].
inline double largest_number(QuantityKind kind) {
  return is_known_magnitude(kind) ? kLargestMagnitude : kLargestNumber;
}

/// The number in SI that a value has become, unless it is too large to be computed with or a unit
/// of the file made it infinite or nothing.
template <class Number>
std::variant<Number, ExpressionError> in_range(const Number& given,
                                               Number number,
                                               QuantityKind kind) {
  const double before = plain(BasicQuantity<Number>{given, {}}).value;
  const double after = plain(BasicQuantity<Number>{number, {}}).value;
  if (!std::isfinite(after)) {
    return too_large();
  }
  if (std::abs(after) > largest_number(kind)) {
    return beyond_computing(largest_number(kind));
  }
  if (after == 0.0 && before != 0.0) {
    return too_small();
  }
  return number;
}

/// The hint for a dimension that does not fit, if the text regrouped has a value that `is_good`.
template <class Number, class Check>
void hint_at_grouping(const Expression& expression,
                      const BasicNameLookup<Number>& lookup,
                      ExpressionError& error,
                      const Check& is_good) {
  const std::optional<Expression> better = regrouped(expression);
  if (error.code != "E0309" || !better) {
    return;
  }
  const auto value = Evaluation<Number>(*better, lookup).run({});
  if (std::holds_alternative<BasicQuantity<Number>>(value) &&
      is_good(std::get<BasicQuantity<Number>>(value))) {
    error.hint = regrouping_hint(*better);
  }
}

template <class Number>
std::variant<BasicQuantity<Number>, ExpressionError> evaluate(
    const Expression& expression,
    const std::type_identity_t<BasicNameLookup<Number>>& lookup,
    std::span<const std::string> known) {
  KINESTAT_EXPECTS(!expression.nodes().empty());
  if constexpr (std::same_as<Number, double>) {
    if (expression.is_number()) {
      return Quantity{expression.nodes()[0].value, {}};
    }
  }
  auto result = Evaluation<Number>(expression, lookup).run(known);
  if (auto* error = std::get_if<ExpressionError>(&result)) {
    hint_at_grouping<Number>(expression, lookup, *error, [](const auto&) { return true; });
  }
  return result;
}

template <class Number>
std::variant<Number, ExpressionError> fit(const std::type_identity_t<BasicQuantity<Number>>& value,
                                          QuantityKind kind,
                                          const FileUnits& units) {
  constexpr UnitScale kTurn{2.0, 1.0, 1};  // [rad]
  if (is_bare(value.dimension)) {
    return in_range(value.value, in_si(value.value, units.scale(kind)), kind);
  }
  if (!fits(value.dimension, kind)) {
    return misfit(value.dimension, kind);
  }
  const bool is_per_radian = kind == QuantityKind::lead && value.dimension.angle == -1;
  return in_range(value.value, is_per_radian ? in_si(value.value, kTurn) : value.value, kind);
}

template <class Number>
std::variant<Number, ExpressionError> evaluate_as(
    QuantityKind kind,
    const Expression& expression,
    const FileUnits& units,
    const std::type_identity_t<BasicNameLookup<Number>>& lookup,
    std::span<const std::string> known) {
  auto value = evaluate<Number>(expression, lookup, known);
  if (auto* error = std::get_if<ExpressionError>(&value)) {
    return std::move(*error);
  }
  auto fitted = fit<Number>(std::get<BasicQuantity<Number>>(value), kind, units);
  if (auto* error = std::get_if<ExpressionError>(&fitted)) {
    error->length = static_cast<int>(expression.text().size());
    hint_at_units(expression, kind, *error);
    hint_at_grouping<Number>(expression, lookup, *error, [&](const BasicQuantity<Number>& better) {
      return std::holds_alternative<Number>(fit<Number>(better, kind, units));
    });
  }
  return fitted;
}

}  // namespace kinestat
