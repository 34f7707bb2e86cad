// The functions of evaluate.hpp and parameters.hpp for the number type Dual.
#include <cmath>
#include <string_view>

#include "core/contract.hpp"
#include "expression/evaluate/evaluate_as.hpp"
#include "expression/evaluate/number_traits.hpp"
#include "expression/evaluate/settled_whole.hpp"
#include "expression/expression.hpp"
#include "expression/parameters/parameter_values.hpp"
#include "expression/units.hpp"
#include "math/numbers/dual.hpp"

namespace kinestat {

template <>
struct NumberTraits<Dual> {
  static Dual number(std::string_view literal, double value);
  static Dual pi();
  static Dual to_si(const Dual& count, const UnitScale& unit);
  static Dual from_si(const Dual& value, const UnitScale& unit);
  static Dual apply(const Node& operation, const Dual& a, const Dual& b);
};

namespace {

bool is_settled_half(double value) {
  return is_settled_whole(2.0 * value) && !is_settled_whole(value);
}

// mod(a, b) = a - b*floor(a/b), whose floor is constant between its jumps; what moves a in
// proportion to b does not come to one.
Dual modulo(const Dual& a, const Dual& b) {
  const Dual quotient = a / b;
  return a - b * staircase(std::floor(settled_whole(quotient.value)),
                           is_settled_whole(quotient.value),
                           quotient);
}

Dual apply_function(Function function, const Dual& a, const Dual& b) {
  switch (function) {
    case Function::sin:
      return sin(a);
    case Function::cos:
      return cos(a);
    case Function::tan:
      return tan(a);
    case Function::asin:
      return asin(a);
    case Function::acos:
      return acos(a);
    case Function::atan:
      return atan(a);
    case Function::atan2:
      return atan2(a, b);
    case Function::sqrt:
      return sqrt(a);
    case Function::abs:
      return abs(a);
    case Function::exp:
      return exp(a);
    case Function::log:
    case Function::ln:
      return log(a);
    case Function::log10:
      return log10(a);
    case Function::min:
      return min(a, b);
    case Function::max:
      return max(a, b);
    case Function::hypot:
      return hypot(a, b);
    case Function::mod:
      return modulo(a, b);
    case Function::floor:
    case Function::ceil:
      return staircase(0.0, is_settled_whole(a.value), a);
    case Function::round:
      return staircase(0.0, is_settled_half(a.value), a);
    case Function::gcd:
      break;
  }
  return staircase(0.0, true, a, b);  // of whole numbers alone
}

}  // namespace

Dual NumberTraits<Dual>::number(std::string_view /*literal*/, double value) {
  return {value, {}};
}

Dual NumberTraits<Dual>::pi() {
  return {};
}

Dual NumberTraits<Dual>::to_si(const Dual& count, const UnitScale& unit) {
  return chain(0.0, unit.factor(), count);
}

Dual NumberTraits<Dual>::from_si(const Dual& value, const UnitScale& unit) {
  return chain(0.0, unit.from_si(1.0), value);
}

Dual NumberTraits<Dual>::apply(const Node& operation, const Dual& a, const Dual& b) {
  switch (operation.kind) {
    case NodeKind::negate:
      return -a;
    case NodeKind::add:
      return a + b;
    case NodeKind::subtract:
      return a - b;
    case NodeKind::multiply:
      return a * b;
    case NodeKind::divide:
      return a / b;
    case NodeKind::power:
      return pow(a, b);
    case NodeKind::function:
      return apply_function(operation.function, a, b);
    case NodeKind::number:
    case NodeKind::unit:
    case NodeKind::name:
    case NodeKind::pi:
      break;
  }
  KINESTAT_EXPECTS(operation.kind == NodeKind::function);
  return {};
}

using DualQuantity = BasicQuantity<Dual>;
using DualLookup = BasicNameLookup<Dual>;

template std::variant<DualQuantity, ExpressionError> evaluate<Dual>(const Expression&,
                                                                    const DualLookup&,
                                                                    std::span<const std::string>);

template std::variant<Dual, ExpressionError> fit<Dual>(const DualQuantity&,
                                                       QuantityKind,
                                                       const FileUnits&);

template std::variant<Dual, ExpressionError> evaluate_as<Dual>(QuantityKind,
                                                               const Expression&,
                                                               const FileUnits&,
                                                               const DualLookup&,
                                                               std::span<const std::string>);

template class BasicParameterTable<Dual>;

BasicParameterValues<Dual> evaluate_parameters(std::span<const Parameter> parameters,
                                               std::span<const int> variables) {
  const auto seed = [variables](int parameter, DualQuantity& quantity) {
    const auto place = std::ranges::find(variables, parameter);
    if (place != variables.end()) {
      const auto index = static_cast<std::size_t>(place - variables.begin());
      quantity.value.derivatives.resize(variables.size(), 0.0);
      quantity.value.derivatives[index] = 1.0;
    }
  };
  return evaluate_in_order<Dual>(parameters, seed);
}

}  // namespace kinestat
