// Any text as an expression: a finite value, or an error with its place.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "expression/evaluate.hpp"
#include "expression/expression.hpp"
#include "fuzz/diagnostic_invariants.hpp"
#include "fuzz/require.hpp"

namespace kinestat::fuzz {

namespace {

const Quantity* find_name(std::string_view name) {
  static const auto kNames = std::to_array<std::pair<std::string_view, Quantity>>({
      {"N1", {.value = 24.0, .dimension = {}}},
      {"N2", {.value = -3.5, .dimension = {}}},
      {"zero", {.value = 0.0, .dimension = {}}},
      {"base", {.value = 7e-3, .dimension = {.length = 1}}},
      {"alpha", {.value = 0.35, .dimension = {.angle = 1}}},
      {"huge", {.value = 1e300, .dimension = {}}},
      {"tiny", {.value = 1e-300, .dimension = {.mass = 1}}},
  });
  const auto* const at =
      std::ranges::find(kNames, name, &std::pair<std::string_view, Quantity>::first);
  return at == kNames.end() ? nullptr : &at->second;
}

bool is_same(const Node& a, const Node& b) {
  return a.kind == b.kind && a.function == b.function && a.left == b.left && a.right == b.right &&
         a.offset == b.offset && a.length == b.length && a.name == b.name && a.value == b.value &&
         a.unit == b.unit;
}

void check_nodes(const Expression& expression) {
  const int size = static_cast<int>(expression.text().size());
  int number = 0;
  for (const Node& node : expression.nodes()) {
    require(node.left < number && node.right < number, "operands stand before their operation");
    require(node.offset >= 0 && node.length >= 0 && node.length <= size - node.offset,
            "a node stands in the text");
    require(node.name < static_cast<int>(expression.names().size()), "a name is listed");
    require(std::isfinite(node.value), "a number is finite");
    ++number;
  }
}

void check_values(const Expression& expression) {
  static const std::array<std::string, 4> kKnown = {"N1", "base", "alpha", "zero"};
  const auto value = evaluate(expression, find_name, kKnown);
  if (const auto* error = std::get_if<ExpressionError>(&value)) {
    check_error(*error, expression.text());
    return;
  }
  require(std::isfinite(std::get<Quantity>(value).value), "a value is finite", expression.text());
  static const FileUnits kUnits;
  // One kind a text, which decides which: all would be as many times slower than the rest.
  const auto& kinds = all_quantity_kinds();
  const QuantityKind kind = kinds[sum_of(expression.text()) % kinds.size()];
  const auto number = evaluate_as(kind, expression, kUnits, find_name, kKnown);
  if (const auto* error = std::get_if<ExpressionError>(&number)) {
    check_error(*error, expression.text());
  } else {
    require(std::isfinite(std::get<double>(number)), "a number in SI is finite");
  }
}

void check_text(std::string_view text) {
  const auto parsed = parse_expression(text);
  if (const auto* error = std::get_if<ExpressionError>(&parsed)) {
    check_error(*error, text);
    return;
  }
  const auto& expression = std::get<Expression>(parsed);
  require(expression.text() == text, "an expression keeps its text", expression.text());
  check_nodes(expression);
  const auto again = parse_expression(expression.text());
  require(std::holds_alternative<Expression>(again), "its text is an expression again");
  require(std::ranges::equal(expression.nodes(), std::get<Expression>(again).nodes(), is_same),
          "its text is the same expression again",
          expression.text());
  check_values(expression);
}

}  // namespace

}  // namespace kinestat::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kinestat::fuzz::check_text(std::string(data, data + size));
  return 0;
}
