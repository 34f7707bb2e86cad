// A number of a file that depends on what is known only once a case is solved.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "expression/evaluate.hpp"

namespace kinestat {

/// A quantity that an expression may name beside the parameters.
template <class Number>
struct LawVariable {
  std::string_view name;
  BasicQuantity<Number> value;
};

/// An expression with the values of its parameters: of a drag, a couple as a function of speed.
/// `Number` is double or Dual.
template <class Number>
class NumberLaw {
 public:
  /// `parameters` are those that the expression refers to.
  NumberLaw(Expression expression,
            QuantityKind kind,
            FileUnits units,
            std::map<std::string, BasicQuantity<Number>, std::less<>> parameters)
      : expression_(std::move(expression)),
        kind_(kind),
        units_(std::move(units)),
        parameters_(std::move(parameters)) {}

  /// The values of its parameters, which may be replaced by others of the same dimension.
  std::map<std::string, BasicQuantity<Number>, std::less<>>& parameters() { return parameters_; }

  /// What the expression refers to, parameters among them.
  std::span<const std::string> names() const { return expression_.names(); }

  /// In SI; errors as of evaluate_as.
  std::variant<Number, ExpressionError> at(std::span<const LawVariable<Number>> variables) const {
    return evaluate_as<Number>(
        kind_, expression_, units_, [&](std::string_view name) -> const BasicQuantity<Number>* {
          for (const LawVariable<Number>& one : variables) {
            if (one.name == name) {
              return &one.value;
            }
          }
          const auto found = parameters_.find(name);
          return found == parameters_.end() ? nullptr : &found->second;
        });
  }

 private:
  Expression expression_;
  QuantityKind kind_;
  FileUnits units_;
  std::map<std::string, BasicQuantity<Number>, std::less<>> parameters_;
};

}  // namespace kinestat
