// What the nodes of an expression do with doubles.
#include <numbers>

#include "core/contract.hpp"
#include "expression/evaluate/arithmetic.hpp"

namespace kinestat {

namespace {

Outcome multiply_by(const Quantity& left, const Unit& unit) {
  return checked({unit.scale.to_si(left.value), left.dimension * unit.dimension},
                 zero_from(left.value));
}

Outcome divide_by(const Quantity& left, const Unit& unit) {
  return checked({unit.scale.from_si(left.value), left.dimension / unit.dimension},
                 zero_from(left.value));
}

}  // namespace

Quantity leaf(const Node& node) {
  switch (node.kind) {
    case NodeKind::unit:
      return {node.unit->scale.factor(), node.unit->dimension};
    case NodeKind::pi:
      return {std::numbers::pi, {}};
    default:
      break;
  }
  KINESTAT_EXPECTS(node.kind == NodeKind::number);
  return {node.value, {}};
}

Outcome operate(const Node& node, const Quantity& left, const Quantity& right, const Unit* unit) {
  switch (node.kind) {
    case NodeKind::negate:
      return Quantity{0.0 - left.value, left.dimension};
    case NodeKind::add:
      return add(left, right);
    case NodeKind::subtract:
      return subtract(left, right);
    case NodeKind::multiply:
      return unit != nullptr ? multiply_by(left, *unit) : multiply(left, right);
    case NodeKind::divide:
      return unit != nullptr ? divide_by(left, *unit) : divide(left, right);
    case NodeKind::power:
      return raise(left, right);
    default:
      break;
  }
  KINESTAT_EXPECTS(node.kind == NodeKind::function);
  return apply(node.function, left, right);
}

}  // namespace kinestat
