// An expression as typed: its text and its tree.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "expression/expression_error.hpp"
#include "expression/functions.hpp"
#include "expression/units.hpp"

namespace kinestat {

enum class NodeKind : std::uint8_t {
  number,
  unit,
  name,
  pi,
  negate,
  add,
  subtract,
  multiply,
  divide,
  power,
  function
};

/// One operation or leaf. Operands are indices of nodes that stand before it; -1 where there is
/// none. A function of more than two values is nested: max(a, b, c) is max(max(a, b), c).
struct Node {
  NodeKind kind = NodeKind::number;
  Function function = Function::sin;  ///< of a function
  int left = -1;                      ///< first operand; of negate the only one
  int right = -1;                     ///< second operand
  int offset = 0;                     ///< [bytes] where its text begins
  int length = 0;                     ///< [bytes] a number's text is the literal as typed
  int name = -1;                      ///< of a name: index into Expression::names()
  double value = 0.0;                 ///< of a number: the nearest double
  const Unit* unit = nullptr;         ///< of a unit
};

/// A tree in one vector, operands before operations and the root last, so that one pass from the
/// front evaluates it for any type of number. A default one is the number 0.
class Expression {
 public:
  Expression() = default;
  Expression(std::string text, std::vector<Node> nodes, std::vector<std::string> names);

  /// As typed.
  const std::string& text() const { return text_; }

  /// Operands before operations, the root last.
  std::span<const Node> nodes() const { return nodes_; }

  /// The names it refers to, each once, in the order of first use.
  std::span<const std::string> names() const { return names_; }

  /// The text of a node; of a number its digits as typed.
  std::string_view text_of(const Node& node) const;

  /// Whether it is a single number without a unit.
  bool is_number() const { return nodes_.size() == 1 && nodes_[0].kind == NodeKind::number; }

 private:
  std::string text_ = "0";
  std::vector<Node> nodes_ = {Node{.length = 1}};
  std::vector<std::string> names_;
};

/// Reads an expression of numbers, names, units, functions, pi, + - * / ^ and parentheses.
/// A unit directly after a number or a parenthesis binds closest: 1/2 mm is 1/(2 mm), so that the
/// half is written (1/2) mm; 1 rad/s is (1 rad)/s and 2 mm^2 is 2*(mm^2). -2^2 is -(2^2); ^ groups
/// to the right. Where such a divisor makes the dimension wrong, evaluation says how to write it.
/// Errors: E0308 for the form, E0311 for a function that does not exist, E0210 above 4096 bytes or
/// 64 levels of nesting.
std::variant<Expression, ExpressionError> parse_expression(std::string_view text);

}  // namespace kinestat
