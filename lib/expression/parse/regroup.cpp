#include "expression/parse/regroup.hpp"

#include <variant>
#include <vector>

#include <fmt/format.h>

#include "expression/parse/characters.hpp"

namespace kinestat {

namespace {

struct Quotient {
  int begin = 0;  // [bytes] of the dividend
  int end = 0;    // [bytes] behind the number of the divisor
};

// For each node, whether a unit stands in it.
std::vector<bool> find_units(std::span<const Node> nodes) {
  std::vector<bool> has_unit;
  has_unit.reserve(nodes.size());
  for (const Node& node : nodes) {
    const auto below = [&](int i) { return i >= 0 && has_unit[static_cast<std::size_t>(i)]; };
    has_unit.push_back(node.kind == NodeKind::unit || below(node.left) || below(node.right));
  }
  return has_unit;
}

// A number and a unit without an operator between them: they begin together, as "2*mm" does too.
bool is_measure(const Expression& expression, const Node& node) {
  const auto nodes = expression.nodes();
  if (node.kind != NodeKind::multiply) {
    return false;
  }
  const Node& number = nodes[static_cast<std::size_t>(node.left)];
  return number.kind == NodeKind::number && number.offset == node.offset &&
         expression.text_of(node).find('*') == std::string_view::npos;
}

// Whether nothing but blanks stands between the divisor and its '/'.
bool follows_slash(const Expression& expression, const Node& divisor) {
  int at = divisor.offset - 1;
  while (at >= 0 && is_space(expression.text()[static_cast<std::size_t>(at)])) {
    --at;
  }
  return at >= 0 && expression.text()[static_cast<std::size_t>(at)] == '/';
}

std::vector<Quotient> find_quotients(const Expression& expression) {
  const auto nodes = expression.nodes();
  const std::vector<bool> has_unit = find_units(nodes);
  std::vector<Quotient> found;
  for (const Node& node : nodes) {
    if (node.kind != NodeKind::divide || has_unit[static_cast<std::size_t>(node.left)]) {
      continue;
    }
    const Node& divisor = nodes[static_cast<std::size_t>(node.right)];
    if (is_measure(expression, divisor) && follows_slash(expression, divisor)) {
      const Node& number = nodes[static_cast<std::size_t>(divisor.left)];
      found.push_back({node.offset, number.offset + number.length});
    }
  }
  return found;
}

}  // namespace

std::optional<Expression> regrouped(const Expression& expression) {
  const std::vector<Quotient> quotients = find_quotients(expression);
  std::string text;
  std::size_t done = 0;
  // Quotients stand in the order of their text and never within each other.
  for (const Quotient& quotient : quotients) {
    const auto begin = static_cast<std::size_t>(quotient.begin);
    const auto end = static_cast<std::size_t>(quotient.end);
    text += expression.text().substr(done, begin - done);
    text += fmt::format("({})", expression.text().substr(begin, end - begin));
    done = end;
  }
  text += expression.text().substr(done);
  auto parsed = parse_expression(text);
  auto* better = std::get_if<Expression>(&parsed);
  return !quotients.empty() && better != nullptr ? std::optional(std::move(*better)) : std::nullopt;
}

std::string regrouping_hint(const Expression& better) {
  return fmt::format("a unit belongs to the number right before it: write {}", better.text());
}

}  // namespace kinestat
