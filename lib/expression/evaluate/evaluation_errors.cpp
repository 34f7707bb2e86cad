#include "expression/evaluate/evaluation_errors.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/spelling.hpp"
#include "core/tolerance.hpp"
#include "expression/parse/characters.hpp"
#include "expression/parse/suggestion.hpp"

namespace kinestat {

namespace {

constexpr std::string_view kOr = " or ";  // between the examples of a kind

// "-500" of -500 Nm; empty of what is more than one number with units.
std::string number_with_units(const Expression& expression) {
  std::string number;
  bool has_unit = false;
  bool is_negative = false;
  for (const Node& node : expression.nodes()) {
    switch (node.kind) {
      case NodeKind::number:
        if (!number.empty()) {
          return {};
        }
        number = expression.text_of(node);
        break;
      case NodeKind::unit:
        has_unit = true;
        break;
      case NodeKind::negate:
        is_negative = !is_negative;
        break;
      case NodeKind::multiply:
      case NodeKind::divide:
        break;
      default:
        return {};
    }
  }
  return has_unit && !number.empty() ? (is_negative ? "-" : "") + number : std::string();
}

}  // namespace

Fault unknown_name(std::string_view name) {
  const std::string word = in_small_letters(name);
  if (word == "nan" || word == "inf" || word == "infinity") {
    return {.code = "E0308",
            .message = fmt::format("'{}' is not a finite number", name),
            .hint = "write a finite number"};
  }
  return {.code = "E0311", .message = fmt::format("unknown name '{}'", name), .hint = {}};
}

ExpressionError located(const Expression& expression,
                        const Node& node,
                        Fault fault,
                        std::span<const std::string> known) {
  const int part = fault.part == Fault::Part::left    ? node.left
                   : fault.part == Fault::Part::right ? node.right
                                                      : -1;
  const Node& shown = part >= 0 ? expression.nodes()[static_cast<std::size_t>(part)] : node;
  if (node.kind == NodeKind::name && fault.hint.empty()) {
    fault.hint = name_hint(expression.text_of(node), known);
  }
  return {.offset = shown.offset,
          .length = shown.length,
          .code = fault.code,
          .message = std::move(fault.message),
          .hint = std::move(fault.hint)};
}

ExpressionError misfit(const Dimension& dimension, QuantityKind kind) {
  return {.code = "E0309",
          .message = fmt::format("expected {}, found {}", phrase_of(kind), phrase_of(dimension)),
          .hint = fmt::format("write {}", example_of(kind))};
}

void hint_at_units(const Expression& expression, QuantityKind kind, ExpressionError& error) {
  const std::string number = number_with_units(expression);
  std::string_view example = example_of(kind);
  if (error.code != "E0309" || number.empty()) {
    return;
  }
  std::string hint = "write";
  while (!example.empty()) {
    const std::string_view one = example.substr(0, example.find(kOr));
    example.remove_prefix(std::min(example.size(), one.size() + kOr.size()));
    const std::size_t space = one.find(' ');
    if (!is_digit(one.front()) || space == std::string_view::npos) {
      return;  // no example of a number with a unit
    }
    hint += fmt::format("{}{}{}",
                        hint.size() > std::string_view("write").size() ? kOr : " ",
                        number,
                        one.substr(space));
  }
  error.hint = std::move(hint);
}

ExpressionError too_large() {
  return {.code = "E0316",
          .message = "the value is out of range in SI units",
          .hint = "write a smaller number"};
}

ExpressionError beyond_computing(double largest) {
  return {.code = "E0320",
          .message = "the value is beyond what can be computed with",
          .hint = largest == kLargestNumber
                      ? fmt::format("numbers of a mechanism reach to {:g} in SI units; for a point "
                                    "that is infinitely far write a direction",
                                    largest)
                      : fmt::format("velocities, forces and moments reach to {:g} in SI units; "
                                    "write a smaller one, to which the answer is proportional",
                                    largest)};
}

ExpressionError too_small() {
  return {.code = "E0316",
          .message = "the value is too small in SI units (underflow)",
          .hint = "write 0, or a larger number"};
}

}  // namespace kinestat
