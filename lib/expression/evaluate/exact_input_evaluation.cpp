// The functions of evaluate.hpp and parameters.hpp for the number type ExactInput.
#include <string_view>
#include <utility>

#include "expression/evaluate/evaluate_as.hpp"
#include "expression/evaluate/exact_arithmetic.hpp"
#include "expression/evaluate/exact_number_traits.hpp"
#include "expression/evaluate/number_traits.hpp"
#include "expression/evaluate/precise_operations.hpp"
#include "expression/expression.hpp"
#include "expression/parameters/parameter_values.hpp"
#include "expression/units.hpp"
#include "math/numbers/exact_input.hpp"

namespace kinestat {

template <>
struct NumberTraits<ExactInput> {
  static ExactInput number(std::string_view literal, double value);
  static ExactInput pi();
  static ExactInput to_si(const ExactInput& count, const UnitScale& unit);
  static ExactInput from_si(const ExactInput& value, const UnitScale& unit);
  static ExactInput apply(const Node& operation, const ExactInput& a, const ExactInput& b);
};

namespace {

// Powers up to this are products.
constexpr int kLargestPower = 16;

BigFloat digits_of(const PiRational& exact) {
  return to_big_float(exact.factor) * pow(big_float_pi(), exact.pi_power);
}

ExactInput exact_input(const PiRational& exact) {
  return {0.0, digits_of(exact), RootSum(exact.factor, 4), exact.pi_power};
}

// The fraction times a power of pi that a number is; empty for other sums of roots.
Exact exact_of(const ExactInput& number) {
  ExactInput factor = number;
  factor.pi_power = 0;
  const std::optional<Rational> fraction = rational_of(factor);
  return {.value = number.value,
          .exact = fraction ? MaybeExact(PiRational{*fraction, number.pi_power}) : std::nullopt};
}

std::optional<int> small_power(const ExactInput& exponent) {
  const std::optional<Rational> value = rational_of(exponent);
  const bool is_small = value && is_whole(*value) && abs(*value) <= kLargestPower;
  return is_small ? std::optional(value->convert_to<int>()) : std::nullopt;
}

std::optional<ExactInput> raised(const ExactInput& base, const ExactInput& exponent) {
  const std::optional<int> power = small_power(exponent);
  if (!power) {
    return std::nullopt;
  }
  ExactInput result(1.0);
  for (int i = 0; i < std::abs(*power); ++i) {
    result = result * base;
  }
  return *power < 0 ? ExactInput(1.0) / result : result;
}

// What fractions do not answer, sums of roots may; of sums, products and quotients at least the
// digits are known.
std::optional<ExactInput> apply_to_roots(const Node& operation,
                                         const ExactInput& a,
                                         const ExactInput& b) {
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
      return raised(a, b);
    default:
      break;
  }
  if (operation.kind != NodeKind::function) {
    return std::nullopt;
  }
  switch (operation.function) {
    case Function::sin:
      return sin(a);
    case Function::cos:
      return cos(a);
    case Function::tan:
      return tan(a);
    case Function::sqrt:
      return sqrt(a);
    case Function::hypot:
      return sqrt(a * a + b * b);
    case Function::abs:
      return abs(a);
    default:
      return std::nullopt;
  }
}

}  // namespace

ExactInput NumberTraits<ExactInput>::number(std::string_view literal, double value) {
  const Exact exact = NumberTraits<Exact>::number(literal, value);
  return exact.exact ? exact_input(*exact.exact)
                     : ExactInput(0.0, precise_number(literal), std::nullopt, 0);
}

ExactInput NumberTraits<ExactInput>::pi() {
  return exact_input_pi();
}

ExactInput NumberTraits<ExactInput>::to_si(const ExactInput& count, const UnitScale& unit) {
  return count * exact_input(size_of(unit));
}

ExactInput NumberTraits<ExactInput>::from_si(const ExactInput& value, const UnitScale& unit) {
  return value / to_si(ExactInput(1.0), unit);
}

ExactInput NumberTraits<ExactInput>::apply(const Node& operation,
                                           const ExactInput& a,
                                           const ExactInput& b) {
  const Exact fraction = NumberTraits<Exact>::apply(operation, exact_of(a), exact_of(b));
  if (fraction.exact) {
    return exact_input(*fraction.exact);
  }
  if (const std::optional<ExactInput> roots = apply_to_roots(operation, a, b)) {
    return *roots;
  }
  const bool has_digits = a.precise && b.precise;
  return {0.0,
          has_digits ? apply_precisely(operation, *a.precise, *b.precise) : std::nullopt,
          std::nullopt,
          0};
}

using ExactInputQuantity = BasicQuantity<ExactInput>;
using ExactInputLookup = BasicNameLookup<ExactInput>;

template std::variant<ExactInputQuantity, ExpressionError> evaluate<ExactInput>(
    const Expression&, const ExactInputLookup&, std::span<const std::string>);

template std::variant<ExactInput, ExpressionError> fit<ExactInput>(const ExactInputQuantity&,
                                                                   QuantityKind,
                                                                   const FileUnits&);

template std::variant<ExactInput, ExpressionError> evaluate_as<ExactInput>(
    QuantityKind,
    const Expression&,
    const FileUnits&,
    const ExactInputLookup&,
    std::span<const std::string>);

template class BasicParameterTable<ExactInput>;

template BasicParameterValues<ExactInput> evaluate_parameters<ExactInput>(
    std::span<const Parameter>);

}  // namespace kinestat
