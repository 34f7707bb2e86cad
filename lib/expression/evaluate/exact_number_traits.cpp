#include "expression/evaluate/exact_number_traits.hpp"

#include "core/contract.hpp"
#include "expression/evaluate/exact_arithmetic.hpp"

namespace kinestat {

namespace {

MaybeExact apply_exactly(const Node& operation, const PiRational& a, const PiRational& b) {
  switch (operation.kind) {
    case NodeKind::negate:
      return negated(a);
    case NodeKind::add:
      return add(a, b);
    case NodeKind::subtract:
      return subtract(a, b);
    case NodeKind::multiply:
      return multiply(a, b);
    case NodeKind::divide:
      return divide(a, b);
    case NodeKind::power:
      return raise(a, b);
    case NodeKind::function:
      return apply(operation.function, a, b);
    case NodeKind::number:
    case NodeKind::unit:
    case NodeKind::name:
    case NodeKind::pi:
      break;
  }
  KINESTAT_EXPECTS(operation.kind == NodeKind::function);
  return std::nullopt;
}

Exact carrying(MaybeExact exact) {
  return {.value = 0.0, .exact = std::move(exact)};
}

}  // namespace

Exact NumberTraits<Exact>::number(std::string_view literal, double /*value*/) {
  const auto decimal = read_decimal(literal);
  return carrying(decimal ? MaybeExact({*decimal, 0}) : std::nullopt);
}

Exact NumberTraits<Exact>::pi() {
  return carrying(PiRational{Rational(1), 1});
}

Exact NumberTraits<Exact>::to_si(const Exact& count, const UnitScale& unit) {
  return carrying(count.exact ? multiply(*count.exact, size_of(unit)) : std::nullopt);
}

Exact NumberTraits<Exact>::from_si(const Exact& value, const UnitScale& unit) {
  return carrying(value.exact ? divide(*value.exact, size_of(unit)) : std::nullopt);
}

Exact NumberTraits<Exact>::apply(const Node& operation, const Exact& a, const Exact& b) {
  return carrying(a.exact && b.exact ? apply_exactly(operation, *a.exact, *b.exact) : std::nullopt);
}

}  // namespace kinestat
