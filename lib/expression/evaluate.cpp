#include "expression/evaluate.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "expression/internal/arithmetic.hpp"
#include "expression/internal/suggestion.hpp"

namespace kinestat {

namespace {

// One pass over the nodes: operands stand before operations.
class Evaluation {
 public:
  Evaluation(const Expression& expression, const NameLookup& lookup)
      : expression_(expression), lookup_(lookup) {}

  std::variant<Quantity, ExpressionError> run(std::span<const std::string> known);

 private:
  Outcome value_of(const Node& node) const;
  Outcome multiply_by(const Node& node) const;
  Outcome divide_by(const Node& node) const;
  Outcome value_of_name(const Node& node) const;
  ExpressionError located(const Node& node, Fault fault) const;

  const Node& operand(int index) const {
    return expression_.nodes()[static_cast<std::size_t>(index)];
  }

  const Quantity& value(int index) const { return values_[static_cast<std::size_t>(index)]; }

  const Expression& expression_;
  const NameLookup& lookup_;
  std::vector<Quantity> values_;  // one a node
};

std::variant<Quantity, ExpressionError> Evaluation::run(std::span<const std::string> known) {
  values_.reserve(expression_.nodes().size());
  for (const Node& node : expression_.nodes()) {
    Outcome outcome = value_of(node);
    if (auto* fault = std::get_if<Fault>(&outcome)) {
      if (node.kind == NodeKind::name) {
        fault->hint = name_hint(expression_.text_of(node), known);
      }
      return located(node, std::move(*fault));
    }
    values_.push_back(std::get<Quantity>(outcome));
  }
  return values_.back();
}

Outcome Evaluation::value_of(const Node& node) const {
  switch (node.kind) {
    case NodeKind::number:
      return Quantity{node.value, {}};
    case NodeKind::unit:
      return Quantity{node.unit->scale.factor(), node.unit->dimension};
    case NodeKind::name:
      return value_of_name(node);
    case NodeKind::pi:
      return Quantity{std::numbers::pi, {}};
    case NodeKind::negate:
      return Quantity{0.0 - value(node.left).value, value(node.left).dimension};
    case NodeKind::add:
      return add(value(node.left), value(node.right));
    case NodeKind::subtract:
      return subtract(value(node.left), value(node.right));
    case NodeKind::multiply:
      return multiply_by(node);
    case NodeKind::divide:
      return divide_by(node);
    case NodeKind::power:
      return raise(value(node.left), value(node.right));
    case NodeKind::function:
      break;
  }
  return apply(node.function, value(node.left), value(node.right < 0 ? node.left : node.right));
}

// By a unit in one rounding where possible: 6 mm is the double nearest to 0.006.
Outcome Evaluation::multiply_by(const Node& node) const {
  const Quantity& left = value(node.left);
  if (const Unit* unit = operand(node.right).unit) {
    return checked({unit->scale.to_si(left.value), left.dimension * unit->dimension});
  }
  return multiply(left, value(node.right));
}

Outcome Evaluation::divide_by(const Node& node) const {
  const Quantity& left = value(node.left);
  if (const Unit* unit = operand(node.right).unit) {
    return checked({unit->scale.from_si(left.value), left.dimension / unit->dimension});
  }
  return divide(left, value(node.right));
}

Outcome Evaluation::value_of_name(const Node& node) const {
  const std::string& name = expression_.names()[static_cast<std::size_t>(node.name)];
  const Quantity* found = lookup_(name);
  if (found == nullptr) {
    return Fault{.code = "E0311", .message = fmt::format("unknown name '{}'", name), .hint = {}};
  }
  return *found;
}

ExpressionError Evaluation::located(const Node& node, Fault fault) const {
  const bool is_left = fault.part == Fault::Part::left && node.left >= 0;
  const bool is_right = fault.part == Fault::Part::right && node.right >= 0;
  const Node& shown = is_left ? operand(node.left) : is_right ? operand(node.right) : node;
  return {.offset = shown.offset,
          .length = shown.length,
          .code = fault.code,
          .message = std::move(fault.message),
          .hint = std::move(fault.hint)};
}

ExpressionError misfit(const Quantity& value, QuantityKind kind) {
  return {.code = "E0309",
          .message = fmt::format(
              "{} stands where {} is expected", phrase_of(value.dimension), phrase_of(kind)),
          .hint = fmt::format("write {}", example_of(kind))};
}

std::variant<double, ExpressionError> finite(double value) {
  if (!std::isfinite(value)) {
    return ExpressionError{.code = "E0316",
                           .message = "the value is out of range in SI units",
                           .hint = "write a smaller number"};
  }
  return value;
}

}  // namespace

const Quantity* no_names(std::string_view /*name*/) {
  return nullptr;
}

std::variant<Quantity, ExpressionError> evaluate(const Expression& expression,
                                                 const NameLookup& lookup,
                                                 std::span<const std::string> known) {
  KINESTAT_EXPECTS(!expression.nodes().empty());
  if (expression.is_number()) {
    return Quantity{expression.nodes()[0].value, {}};
  }
  return Evaluation(expression, lookup).run(known);
}

std::variant<double, ExpressionError> fit(const Quantity& value,
                                          QuantityKind kind,
                                          const FileUnits& units) {
  if (is_bare(value.dimension)) {
    return finite(units.to_si(kind, value.value));
  }
  if (!fits(value.dimension, kind)) {
    return misfit(value, kind);
  }
  const bool is_per_radian = kind == QuantityKind::lead && value.dimension.angle == -1;
  return finite(is_per_radian ? value.value * 2.0 * std::numbers::pi : value.value);
}

std::variant<double, ExpressionError> evaluate_as(QuantityKind kind,
                                                  const Expression& expression,
                                                  const FileUnits& units,
                                                  const NameLookup& lookup,
                                                  std::span<const std::string> known) {
  auto value = evaluate(expression, lookup, known);
  if (auto* error = std::get_if<ExpressionError>(&value)) {
    return std::move(*error);
  }
  auto fitted = fit(std::get<Quantity>(value), kind, units);
  if (auto* error = std::get_if<ExpressionError>(&fitted)) {
    error->length = static_cast<int>(expression.text().size());
  }
  return fitted;
}

}  // namespace kinestat
